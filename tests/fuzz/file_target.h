// What the fuzz targets of the importers share: bytes become a file, the file is imported as a model would.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace fuzz {

/// Imports the bytes as a file with the suffix: "stl". Aborts where what comes out is no mesh or outline at all
/// (corners that are not there, coordinates that are no numbers). What is wrong with a file may only be a warning.
void import_solid(const std::uint8_t* data, std::size_t size, const std::string& suffix);
void import_outline(const std::uint8_t* data, std::size_t size, const std::string& suffix);
void import_surface(const std::uint8_t* data, std::size_t size, const std::string& suffix);

}  // namespace fuzz
