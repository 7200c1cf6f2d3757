// A Markdown table as a plot:  csgscope_plot TITLE X-LABEL Y-LABEL [--log] <TABLE >SVG
// The first column is x, each of the others a line of its own; --log: both axes are logarithmic.
#include <exception>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/plot/plot.h"

namespace {

/// What stands between the bars of a row, without spaces and backquotes about it.
std::vector<std::string> cells(const std::string& row) {
    std::vector<std::string> result;
    std::istringstream text(row.substr(row.find('|') + 1));
    for (std::string cell; std::getline(text, cell, '|');) {
        const auto first = cell.find_first_not_of(" `"), last = cell.find_last_not_of(" `");
        result.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
    }
    return result;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 4) {
        std::cerr << "usage: csgscope_plot TITLE X-LABEL Y-LABEL [--log] <TABLE >SVG\n";
        return 2;
    }
    const bool logarithmic = argc > 4 && std::string(argv[4]) == "--log";
    plot::Plot plot{argv[1], {argv[2], logarithmic}, {argv[3], logarithmic}, {}};
    int number = 0;
    for (std::string row; std::getline(std::cin, row); ++number) {
        const std::vector<std::string> values = cells(row);
        if (number == 0) {
            for (std::size_t i = 1; i < values.size(); ++i) {
                plot.series.push_back({values[i], {}});
            }
        } else if (number > 1) {  // Behind the line below the head.
            if (values.size() != plot.series.size() + 1) {
                std::cerr << "row " << number + 1 << " has another number of cells than the head\n";
                return 1;
            }
            try {
                for (std::size_t i = 1; i < values.size(); ++i) {
                    plot.series[i - 1].points.emplace_back(std::stod(values[0]), std::stod(values[i]));
                }
            } catch (const std::exception&) {
                std::cerr << "row " << number + 1 << " has a cell that is no number\n";
                return 1;
            }
        }
    }
    std::cout << to_svg(plot);
}
