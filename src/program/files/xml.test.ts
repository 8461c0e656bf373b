import fc from "fast-check";
import { expect, test } from "vitest";
import { attributeOf, elementsIn, isXml, readXml, textInside, XML_LIMITS, xmlText, type XmlElement } from "./xml.ts";

/** The tree as brackets: name, attributes, content. */
const short = (e: XmlElement | null): unknown =>
  e && [e.name, Object.fromEntries(e.attributes), ...e.content.map((c) => (typeof c === "string" ? c : short(c)))];

test.each<readonly [string, unknown]>([
  ["<a/>", ["a", {}]],
  ['<?xml version="1.0"?>\n<!-- x -->\n<a b="1" c=\'2\'>t</a >', ["a", { b: "1", c: "2" }, "t"]],
  ["<a><b>1</b> <b>2</b>end</a>", ["a", {}, ["b", {}, "1"], ["b", {}, "2"], "end"]],
  ['<a b="&lt;&#65;&#x42;&amp;"/>', ["a", { b: "<AB&" }]],
  ["<a><![CDATA[1 < 2 &amp;]]></a>", ["a", {}, "1 < 2 &amp;"]],
  ['<!DOCTYPE a [<!ENTITY e "x>y"> <!-- ] --> ]><a>&e;</a>', ["a", {}, "&e;"]],
  ['<s:svg xmlns:s="u"><s:g s:id="1"/></s:svg>', ["s:svg", { "xmlns:s": "u" }, ["s:g", { "s:id": "1" }]]],
  ["<Größe Ä='ü'/>", ["Größe", { Ä: "ü" }]],
])("%s", (text, tree) => {
  const { root, faults } = readXml(text);
  expect(faults).toEqual([]);
  expect(short(root)).toEqual(tree);
});

test.each<readonly [string, string, readonly (readonly [string, number])[], unknown]>([
  ["no XML", "0\nSECTION", [["notXml", 0]], null],
  ["an end is missing", "<a>\n<b>1", [["cut", 0]], ["a", {}, ["b", {}]]],
  ["ends are exchanged", "<a><b>1</a></b>", [["mismatch", 1]], ["a", {}, ["b", {}, "1"]]],
  ["an end of nothing", "<a>\n</b></a>", [["mismatch", 2]], ["a", {}]],
  ["an attribute without value", "<a>\n\n<b c/>2</a>", [["syntax", 3]], ["a", {}, "2"]],
  ["a comment without end", "<a><b/><!-- ", [["cut", 1]], ["a", {}, ["b", {}]]],
])("%s", (_, text, faults, tree) => {
  const read = readXml(text);
  expect(read.faults.map((f) => [f.code, f.line])).toEqual(faults);
  expect(short(read.root)).toEqual(tree);
});

test("entities of the file are never expanded, and nesting has a limit", () => {
  const bomb = `<!DOCTYPE l [${Array.from({ length: 9 }, (_, i) => `<!ENTITY l${i} "${`&l${i - 1};`.repeat(10)}">`).join("")}]><l>&l8;</l>`;
  expect(short(readXml(bomb).root)).toEqual(["l", {}, "&l8;"]);
  const deep = readXml("<a>".repeat(1e5));
  expect(deep.faults.map((f) => f.code)).toEqual(["tooDeep"]);
  expect(xmlText("&#xD800;&#0;&none;&#x1F600;")).toBe("&#xD800;&#0;&none;😀");
});

test("parts of an element", () => {
  const { root } = readXml('<a x:href="1"><b>1<c>2</c></b><d/>3</a>');
  if (!root) throw new Error("no element");
  expect(elementsIn(root).map((e) => e.local)).toEqual(["b", "d"]);
  expect(elementsIn(root, "d").map((e) => e.line)).toEqual([1]);
  expect(textInside(root)).toBe("123");
  expect([attributeOf(root, "href"), attributeOf(root, "x:href"), attributeOf(root, "id")]).toEqual([
    "1",
    "1",
    undefined,
  ]);
});

const piece = fc.constantFrom(
  "<",
  ">",
  "/",
  "a",
  " ",
  "=",
  '"',
  "'",
  "<!--",
  "-->",
  "<![CDATA[",
  "]]>",
  "<!",
  "[",
  "&#",
  ";",
  "<?",
  "?>",
  "\n",
  "</a>",
);
test("rubbish neither throws nor hangs", () => {
  fc.assert(
    fc.property(fc.array(piece, { maxLength: 60 }), (pieces) => {
      const text = `<a>${pieces.join("")}`;
      const read = readXml(text);
      expect(isXml(text)).toBe(true);
      expect(read.root?.name.startsWith("a")).toBe(true);
      expect(read.faults.length).toBeLessThanOrEqual(XML_LIMITS.faults);
    }),
    { numRuns: 300, seed: 41 },
  );
});
