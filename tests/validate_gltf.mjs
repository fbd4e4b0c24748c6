// Runs the Khronos glTF validator over files and prints every issue; exits 1 if any is an error or a
// warning. The npm package gltf-validator is looked for as node does, or in the folder named by
// GLTF_VALIDATOR_HOME (where `npm install --prefix FOLDER gltf-validator` put it).
//
// Usage: node validate_gltf.mjs FILE...
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, resolve } from "node:path";

const home = process.env.GLTF_VALIDATOR_HOME;
const require = createRequire(home ? resolve(home, "package.json") : import.meta.url);
const validator = require("gltf-validator");
const severities = ["error", "warning", "info", "hint"];

async function validate(file) {
  const report = await validator.validateBytes(new Uint8Array(readFileSync(file)), {
    uri: file,
    maxIssues: 100,
    externalResourceFunction: async (uri) =>
      new Uint8Array(readFileSync(resolve(dirname(file), decodeURIComponent(uri)))),
  });
  const { messages, numErrors, numWarnings } = report.issues;
  for (const { severity, code, message, pointer } of messages)
    console.log(`${file}: ${pointer ?? ""}: ${severities[severity]}: ${code}: ${message}`);
  const triangles = report.info?.totalTriangleCount ?? 0;
  console.log(`${file}: ${numErrors} errors, ${numWarnings} warnings; ${triangles} triangles`);
  return numErrors === 0 && numWarnings === 0;
}

const files = process.argv.slice(2);
if (files.length === 0) {
  console.error("usage: node validate_gltf.mjs FILE...");
  process.exit(2);
}
let clean = true;
for (const file of files) {
  try {
    clean = (await validate(file)) && clean;
  } catch (error) {
    console.error(`${file}: ${error.message ?? error}`);
    clean = false;
  }
}
process.exit(clean ? 0 : 1);
