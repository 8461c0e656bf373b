import js from "@eslint/js";
import reactHooks from "eslint-plugin-react-hooks";
import { defineConfig } from "eslint/config";
import tseslint from "typescript-eslint";
import { own } from "./scripts/lint/linear-patterns.mjs";

/** No file is longer than this; tables of data and texts aside. */
const LONGEST = 380;
/** More arguments than this cannot be told apart where they stand. */
const MOST_ARGUMENTS = 6;

const form = [
  { selector: "ExportAllDeclaration", message: "Name what is exported." },
  {
    selector: "ExportDefaultDeclaration",
    message: "Named exports only.",
  },
  { selector: "TSEnumDeclaration", message: "Use a union of literals." },
  {
    selector: "ConditionalExpression > ConditionalExpression > ConditionalExpression",
    message: "More than three cases: return early, or look the case up.",
  },
];
const casts = [
  {
    selector: "CallExpression[callee.name='diameter']",
    message: "A diameter is born in units.ts, in parameters or in a reader; convert with toDiameter().",
  },
];
const pure = {
  globals: [
    "error",
    "Date",
    "localStorage",
    "sessionStorage",
    "indexedDB",
    "window",
    "document",
    "setTimeout",
    "setInterval",
    "performance",
  ],
  properties: ["error", { object: "Math", property: "random", message: "Pure layers repeat themselves exactly." }],
};

/** The page asks one clock and draws by one lot, so that a test can hold both. */
const held = {
  properties: [
    ["Date", "now"],
    ["performance", "now"],
    ["Math", "random"],
    ["crypto", "randomUUID"],
    ["crypto", "getRandomValues"],
  ].map(([object, property]) => ({
    object,
    property,
    message: "Ask src/app/base/clock.ts for the time and src/app/base/random-id.ts for an id.",
  })),
  syntax: {
    selector: "NewExpression[callee.name='Date'][arguments.length=0]",
    message: "Ask src/app/base/clock.ts for the time.",
  },
};

export default defineConfig([
  { ignores: ["node_modules", "dist", "coverage", "test-results", "playwright-report"] },
  js.configs.recommended,
  tseslint.configs.recommended,
  {
    linterOptions: { reportUnusedDisableDirectives: "error" },
    rules: {
      "no-eval": "error",
      "no-implied-eval": "error",
      "no-new-func": "error",
      eqeqeq: "error",
      "no-useless-assignment": "off",
      "no-warning-comments": "error",
      "max-lines": ["error", LONGEST],
      "max-params": ["error", MOST_ARGUMENTS],
      "@typescript-eslint/consistent-type-imports": "error",
      "@typescript-eslint/no-empty-object-type": "off",
      "@typescript-eslint/no-unused-vars": [
        "error",
        {
          argsIgnorePattern: "^_",
          varsIgnorePattern: "^_",
          destructuredArrayIgnorePattern: "^_",
          ignoreRestSiblings: true,
        },
      ],
    },
  },
  {
    files: ["**/*.{js,mjs}"],
    languageOptions: {
      globals: { process: "readonly", console: "readonly", performance: "readonly", URL: "readonly" },
    },
    rules: { "no-undef": "off" },
  },
  {
    files: ["src/**/*.{ts,tsx}", "scripts/**/*.ts", "e2e/**/*.ts", "tests/**/*.ts"],
    rules: { "no-restricted-syntax": ["error", ...form] },
  },
  {
    files: ["src/**/*.{ts,tsx}", "scripts/serve.mjs"],
    ignores: ["**/*.test.{ts,tsx}"],
    plugins: { own },
    rules: { "own/linear-patterns": "error" },
  },
  {
    files: ["src/{kernel,nc,control-file,cycles,program,sim,view,i18n,report,course}/**/*.ts"],
    ignores: ["**/*.test.ts"],
    rules: { "no-restricted-globals": pure.globals, "no-restricted-properties": pure.properties },
  },
  {
    files: ["src/{kernel,cycles,sim}/**/*.ts"],
    ignores: ["**/*.test.ts", "src/kernel/units.ts", "src/cycles/params.ts"],
    rules: { "no-restricted-syntax": ["error", ...form, ...casts] },
  },
  {
    files: [
      "src/i18n/**",
      "src/app/fields/blocks/block-fields.ts",
      "tests/validation-rules.ts",
      "src/program/tools/tool-table.test.ts",
      "src/view/help/tiles.ts",
      "src/kernel/contour/undercut.test.ts",
      "src/nc/iso/read-iso.test.ts",
      "tests/laws/statements.ts",
    ],
    rules: { "max-lines": "off" },
  },
  {
    files: ["src/{app,features,shell}/**/*.{ts,tsx}"],
    ignores: ["**/*.test.{ts,tsx}", "src/app/base/clock.ts", "src/app/base/random-id.ts"],
    rules: {
      "no-restricted-properties": ["error", ...held.properties],
      "no-restricted-syntax": ["error", ...form, held.syntax],
    },
  },
  // The other rules of this plugin run React's compiler, which takes as long as all other rules; tests are not compiled.
  {
    files: ["src/{app,features,shell}/**/*.{ts,tsx}"],
    ignores: ["**/*.test.{ts,tsx}"],
    ...reactHooks.configs.flat["recommended-latest"],
  },
  {
    files: ["src/{app,features,shell}/**/*.test.{ts,tsx}"],
    plugins: { "react-hooks": reactHooks },
    rules: { "react-hooks/rules-of-hooks": "error", "react-hooks/exhaustive-deps": "warn" },
  },
]);
