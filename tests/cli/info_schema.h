// What `himalaya info --json` prints against docs/info.schema.json.
#pragma once

#include <string>

namespace hm::test {

// Fails where the text is not what the schema describes, of the keywords that the file uses. An
// object may have no field that the schema does not know: the document would lag behind.
void expect_fits_schema(const std::string& json);

}  // namespace hm::test
