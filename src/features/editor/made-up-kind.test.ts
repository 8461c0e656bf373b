import { expect, test } from "vitest";
import { fieldsIn } from "../../app/fields/blocks/block-fields.ts";
import { defineBlock } from "../../nc/blocks/define.ts";
import { grammarOf } from "../../nc/blocks/grammar.ts";
import { blocks } from "../../nc/blocks/index.ts";
import { choice, value } from "../../nc/blocks/words.ts";
import { LAYOUTS } from "../../nc/style.ts";
import { paletteOf } from "./palette.ts";

/* A kind of block that no control has: this declaration is its only code. */
const warmUp = defineBlock({
  kind: "warmUp",
  keyword: "WARM UP",
  words: [
    choice("what", ["SPINDLE", "AXES"], { compared: true }),
    value("heat", "HEAT", { unit: "°", plain: true, needed: true, spread: { times: [0.5, 2] } }),
    value("time", "T"),
  ],
  tags: ["leadsTool"],
  part: "operations",
  offered: { group: "technology", begins: { kind: "warmUp", what: "SPINDLE", heat: 40, time: null } },
  sample: ["> WARM UP SPINDLE HEAT40"],
});
const grammar = grammarOf([...blocks, warmUp]);
const read = (text: string) => grammar.read([{ text, offset: 0, comment: null }]);
const line = (s: { readonly kind: string }) => grammar.lines(s, LAYOUTS.tnc7).join("\n");

test("a kind that is declared is read and printed", () => {
  const { statement, issues } = read("WARM  UP axes T5 HEAT 40,5");
  expect(statement).toEqual({ kind: "warmUp", what: "AXES", heat: 40.5, time: 5 });
  expect(issues).toEqual([]);
  expect(line(statement)).toBe("WARM UP AXES HEAT40.5 T+5");
  expect(read("WARM UP AXES").issues.map(({ data }) => data)).toEqual([{ word: "HEAT" }]);
  expect(read("WARM UP 5").statement.kind).toBe("unknown");
});

test("its form asks for its words in their order, and writes them", () => {
  const { statement } = read("WARM UP AXES HEAT40");
  const fields = fieldsIn(grammar)(statement);
  expect(fields.map((field) => [field.id, field.unit ?? "", field.read(statement)])).toEqual([
    ["what", "", "AXES"],
    ["heat", "°", "40"],
    ["time", "", ""],
  ]);
  const written = fields.map((field, i) => field.write(statement, ["SPINDLE", "1+2", "Q5"][i] ?? ""));
  expect(written.map((s) => s && line(s))).toEqual([
    "WARM UP SPINDLE HEAT40",
    "WARM UP AXES HEAT3",
    "WARM UP AXES HEAT40 T+Q5",
  ]);
  expect(fields[1]?.write(statement, "warm")).toBeNull();
});

test("it is compared word by word, offered by the palette, and known by its tags", () => {
  const { statement } = read("WARM UP AXES HEAT40");
  const { nameKey, comparedWords } = grammar.compared(statement, "");
  expect([nameKey, ...(comparedWords?.words ?? [])]).toEqual(["warmUp", ["", "AXES"], ["HEAT", "40"]]);
  const offered = paletteOf(grammar).find(({ kind }) => String(kind) === "warmUp");
  expect(offered && [offered.group, line(offered.make?.("en") ?? statement)]).toEqual([
    "technology",
    "WARM UP SPINDLE HEAT40",
  ]);
  expect([grammar.has(statement, "leadsTool"), grammar.has(statement, "note")]).toEqual([true, false]);
  expect(new Map(grammar.named).get("warmUp")?.sample).toEqual(["> WARM UP SPINDLE HEAT40"]);
});
