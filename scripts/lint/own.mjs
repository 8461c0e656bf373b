import { linearPatterns } from "./linear-patterns.mjs";

/** A rule that refuses what a selector finds, with a message for each. */
const refuses = (messages) => ({
  meta: { type: "problem", schema: [] },
  create: (context) =>
    Object.fromEntries(
      Object.entries(messages).map(([selector, message]) => [selector, (node) => context.report({ node, message })]),
    ),
});

const ASK = "Ask src/app/base/clock.ts for the time and src/app/base/random-id.ts for an id.";

/** The rules of this project. */
export default {
  meta: { name: "own" },
  rules: {
    "linear-patterns": linearPatterns,
    form: refuses({
      ExportAllDeclaration: "Name what is exported.",
      ExportDefaultDeclaration: "Named exports only.",
      TSEnumDeclaration: "Use a union of literals.",
      "ConditionalExpression > ConditionalExpression > ConditionalExpression":
        "More than three cases: return early, or look the case up.",
    }),
    diameters: refuses({
      "CallExpression[callee.name='diameter']":
        "A diameter is born in units.ts, in parameters or in a reader; convert with toDiameter().",
    }),
    "clock-and-lot": refuses({
      "NewExpression[callee.name='Date'][arguments.length=0]": ASK,
      "MemberExpression[object.name=/^(Date|performance)$/][property.name='now']": ASK,
      "MemberExpression[object.name='Math'][property.name='random']": ASK,
      "MemberExpression[object.name='crypto'][property.name=/^(randomUUID|getRandomValues)$/]": ASK,
    }),
  },
};
