import fc from "fast-check";
import { expect, test } from "vitest";
import { xmlText } from "../program/files/xml.ts";
import { escapedText } from "./markup.ts";

test("any text stays text between tags and in an attribute, and XML may hold it", () => {
  expect(escapedText(`<a b="c">'&amp;'\u0000\u001b\ud800`)).toBe(
    "&lt;a b=&quot;c&quot;&gt;&#39;&amp;amp;&#39;\uFFFD\uFFFD\uFFFD",
  );
  fc.assert(
    fc.property(fc.string({ unit: "grapheme" }), (text) => {
      expect(escapedText(text)).not.toMatch(/[<>"']/);
      expect(xmlText(escapedText(text))).toBe(text);
    }),
  );
});
