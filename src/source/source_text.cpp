#include <iecfront/source/source_text.hpp>

#include <utility>

namespace iecfront {

SourceText::SourceText(std::string bytes, std::string name, Encoding encoding)
    : name_(std::move(name)), encoding_(encoding), too_large_(bytes.size() > maximum_size) {
    if (too_large_)
        bytes = {};
    buffer_ = std::make_shared<const std::string>(std::move(bytes));
}

} // namespace iecfront
