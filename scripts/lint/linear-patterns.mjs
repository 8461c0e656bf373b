import { growthOf } from "./pattern-growth.mjs";

/** Every pattern is read in linear time, as a literal and as a `new RegExp` of constants of its file. */
export const linearPatterns = {
  meta: {
    type: "problem",
    schema: [],
    messages: {
      grows:
        "The time of this pattern grows faster than its text, for one with {{text}} over and over: no two repeats in a row may take the same characters, and a search may not begin in the middle of what it repeats.",
    },
  },
  create(context) {
    const check = (node, source, flags) => {
      let text;
      try {
        text = growthOf(source, flags);
      } catch {
        return; // A pattern that is none is told by no-invalid-regexp.
      }
      if (text !== null) context.report({ node, messageId: "grows", data: { text: JSON.stringify(text) } });
    };
    const made = (node) => {
      if (node.callee.type !== "Identifier" || node.callee.name !== "RegExp") return;
      const [source, flags] = node.arguments.map((each) => textOf(each, context.sourceCode.getScope(node)));
      if (typeof source === "string") check(node, source, flags ?? "");
    };
    return {
      Literal(node) {
        if (node.regex) check(node, node.regex.pattern, node.regex.flags);
      },
      NewExpression: made,
      CallExpression: made,
    };
  },
};

/** The text of an expression of constants; undefined where it is known only later. */
function textOf(node, scope) {
  switch (node?.type) {
    case "Literal":
      return typeof node.value === "string" ? node.value : undefined;
    case "TemplateLiteral":
      return joined(node, scope, (quasi) => quasi.value.cooked);
    case "TaggedTemplateExpression":
      return node.tag.type === "MemberExpression" && node.tag.property.name === "raw"
        ? joined(node.quasi, scope, (quasi) => quasi.value.raw)
        : undefined;
    case "BinaryExpression": {
      const sides = node.operator === "+" ? [textOf(node.left, scope), textOf(node.right, scope)] : [undefined];
      return sides.includes(undefined) ? undefined : sides.join("");
    }
    case "Identifier": {
      let found;
      for (let at = scope; at && !found; at = at.upper) found = at.set.get(node.name);
      const [definition] = found?.defs ?? [];
      return definition?.type === "Variable" && definition.parent.kind === "const" && definition.node.init
        ? textOf(definition.node.init, found.scope)
        : undefined;
    }
    default:
      return undefined;
  }
}

function joined({ quasis, expressions }, scope, text) {
  const between = expressions.map((each) => textOf(each, scope));
  return between.includes(undefined) ? undefined : quasis.map((quasi, i) => text(quasi) + (between[i] ?? "")).join("");
}
