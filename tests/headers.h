// Headers of others that many tests include; precompiled (cmake/parse_once.cmake). No file relies on it.
#pragma once

#include <gtest/gtest.h>

#include "cmake/headers.h"
