import { expect, test } from "vitest";
import { guideBlocks } from "../../i18n/en/guide-blocks.ts";
import { never } from "../../kernel/never.ts";
import { parse } from "../../nc/parse.ts";
import { run } from "../../program/run/run.ts";
import { shippedTools } from "../../program/tools/shipped-tools.ts";
import { simulate } from "../../sim/simulate.ts";
import { fieldsOf } from "../../app/fields/blocks/block-fields.ts";
import { spreadOf, textsBeside, wordOfField } from "../../app/fields/blocks/block-guide.ts";
import type { BlockKind } from "../../nc/blocks/names.ts";
import { kindOf } from "../../app/fields/blocks/block-kind.ts";
import { palette } from "../editor/palette.ts";
import { blockSources, textWith, type BlockSource } from "./block-source.ts";
import { whyUnseen } from "./block-samples.ts";
import { blockRule, blockWordTexts } from "./block-words.ts";

const kinds = Object.keys(guideBlocks.kinds) as (keyof typeof guideBlocks.kinds & BlockKind)[];
const ran = (text: string) => run(parse(text), { tools: shippedTools, rapid: 10_000 });
const own = (source: BlockSource) => source.program.blocks.map(({ raw }) => raw).join("");

/** Words that make no difference in their sample: no function that uses them is active there. */
const SAME: ReadonlySet<string> = new Set(["toolCall.feed", "cycleCall.feed", "free.X", "free.Z", "free.feed"]);

test("every kind of block that can be inserted has its page, and every word in it its text", () => {
  const offered = palette
    .map(({ kind }) => kind)
    .filter((kind) => kind !== "cycle" && kind !== "approach" && kind !== "departure");
  expect(offered.filter((kind) => !kinds.some((page) => page === kind))).toEqual([]);
  for (const { kind, make } of palette) {
    const statement = make?.("en");
    if (!statement || statement.kind === "approach") continue;
    for (const field of fieldsOf(statement))
      expect(blockWordTexts(guideBlocks, kind, field), `${kind} ${field.id}`).not.toBeNull();
  }
  for (const id of Object.keys(guideBlocks.rules))
    expect(blockRule(guideBlocks, id.split(".")[0] as BlockKind, id.split(".").at(-1) ?? "")).not.toBe("");
});

test("a small and a large value of a word make another run than the default one, which the control would accept", () => {
  for (const kind of kinds) {
    const [shown] = blockSources(kind, null);
    for (const field of shown ? fieldsOf(shown.statement) : []) {
      const word = wordOfField(field),
        spread = spreadOf(field);
      const [source] = blockSources(kind, word);
      if (!spread || !source || "tools" in spread || SAME.has(`${kind}.${word}`)) continue;
      const usual = field.read(source.statement),
        texts = textsBeside(spread, usual);
      expect(texts.length, `${kind}.${word}`).toBeGreaterThan(1);
      const before = ran(own(source));
      expect(
        before.issues.filter(({ issue }) => issue.severity === "error"),
        `${kind}.${word}`,
      ).toEqual([]);
      const other = texts.find((text) => text !== usual) ?? never("no other");
      const after = ran(textWith(source, field, other) ?? never(`${kind}.${word} = ${other}`));
      const path = ({ steps, blank, seconds }: typeof after) =>
        JSON.stringify([blank, seconds, steps.map(({ move }) => move)]);
      const isOther =
        path(after) !== path(before) ||
        JSON.stringify(simulate(after).final) !== JSON.stringify(simulate(before).final);
      expect(isOther, `${kind}.${word} = ${other}`).toBe(true);
    }
  }
});

test("every word without pictures says why", () => {
  const unsaid = kinds.flatMap((kind) => {
    const [shown] = blockSources(kind, null);
    return (shown ? fieldsOf(shown.statement) : [])
      .filter((field) => !spreadOf(field) && whyUnseen(kind, field) === "same")
      .map((field) => `${kind}.${wordOfField(field)}`);
  });
  expect(unsaid).toEqual([]);
  const why = (line: string, id: string) => {
    const s = parse(line).blocks[0]?.statement ?? never(line);
    return whyUnseen(kindOf(s), fieldsOf(s).find((field) => field.id === id) ?? never(id));
  };
  expect([why("L X+1", "Y"), why("CALL LBL 1", "label"), why("TOOL CALL 1", "deltaRadius")]).toEqual([
    "axis",
    "name",
    "milling",
  ]);
});

test("another tool leaves another part", () => {
  const [source] = blockSources("toolCall", "tool");
  const field = source && fieldsOf(source.statement).find(({ id }) => id === "tool");
  if (!source || !field) throw never("no tool");
  const part = (text: string) => JSON.stringify(simulate(ran(text)).final);
  expect(part(textWith(source, field, "11") ?? "")).not.toBe(part(own(source)));
});
