#pragma once

#include <stdexcept>

namespace iecfront::cli {

/// What stands on the command line makes no sense.
class UsageError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

} // namespace iecfront::cli
