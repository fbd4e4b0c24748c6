// Checks the output of `himalaya info --json` against docs/info.schema.json.
#pragma once

#include <string>

namespace hm::test {

// Fails if the text does not fit the schema, as far as the keywords that the schema uses. Fields
// that the schema does not know are errors, so that the document stays complete.
void expect_fits_schema(const std::string& json);

}  // namespace hm::test
