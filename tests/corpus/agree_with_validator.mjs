// Compares the Khronos glTF Validator with the manifest of the corpus: it must report an error for
// every broken file except those whose manifest entry says why it does not, and none for valid
// ones. GLTF_VALIDATOR_HOME is as for validate_gltf.mjs.
//
// Usage: node agree_with_validator.mjs FOLDER [-v]    (-v: also print the validator's messages)
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";

const home = process.env.GLTF_VALIDATOR_HOME;
const require = createRequire(home ? resolve(home, "package.json") : import.meta.url);
const validator = require("gltf-validator");

const [folder, verbose] = process.argv.slice(2);
if (folder === undefined) {
  console.error("usage: node agree_with_validator.mjs FOLDER [-v]");
  process.exit(2);
}

// The validator's messages; a file that it can't even open counts as an error.
async function messages(file) {
  const bytes = new Uint8Array(readFileSync(join(folder, file)));
  try {
    const { issues } = await validator.validateBytes(bytes, {
      uri: file,
      format: file.endsWith(".glb") ? "glb" : "gltf",
      maxIssues: 100,
      externalResourceFunction: async (uri) => {
        throw new Error(`${uri} is absent`);
      },
    });
    return issues.messages;
  } catch (error) {
    return [{ severity: 0, code: "EXCEPTION", message: String(error), pointer: "" }];
  }
}

const { valid, broken } = JSON.parse(readFileSync(join(folder, "manifest.json"), "utf8"));
let wrong = 0;
const expected = [
  ...valid.map((file) => ({ file, validator: "no error", rule: "valid" })),
  ...broken,
];
for (const { file, rule, validator: verdict } of expected) {
  const found = await messages(file);
  const actual = found.some(({ severity }) => severity === 0) ? "error" : "no error";
  const lines = found.map(
    ({ severity, code, pointer, message }) => `    ${severity} ${code} ${pointer ?? ""} ${message}`,
  );
  if (actual !== verdict) ++wrong;
  if (actual !== verdict || verbose)
    console.log([`${file} (${rule}): ${actual}, expected ${verdict}`, ...lines].join("\n"));
}
console.log(`${expected.length} files, ${wrong} on which validator and manifest disagree`);
process.exit(wrong === 0 ? 0 : 1);
