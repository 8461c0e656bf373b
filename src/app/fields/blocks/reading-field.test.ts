import { EditorState } from "@codemirror/state";
import * as fc from "fast-check";
import { expect, test } from "vitest";
import { parse } from "../../../nc/parse.ts";
import { isRead, readFurther, readingField } from "./reading-field.ts";

const part =
  "12 CYCL DEF 207 TAPPING ~\n  Q200=+2.5 ;SET-UP CLEARANCE ~\n\n  Q201=-18.3 ;DEPTH\n\n13 L X+31.7 Z-4.25 ; a\n";
const long = part.repeat(2000);
const stateOf = (doc: string) => EditorState.create({ doc, extensions: [readingField] });

function readAll(state: EditorState): EditorState {
  let now = state;
  for (let pieces = 0; !isRead(now) && pieces < 100; pieces += 1) now = now.update(readFurther).state;
  return now;
}

test("the first blocks of a long text are there at once, the others piece by piece", () => {
  const state = stateOf(long);
  const { blocks } = state.field(readingField).program;
  expect(isRead(state)).toBe(false);
  expect(blocks.length).toBeGreaterThan(1000);
  expect(blocks.slice(0, -1)).toEqual(parse(long).blocks.slice(0, blocks.length - 1));
  expect(readAll(state).field(readingField).program).toEqual(parse(long));
});

test("a text of one endless line and an empty one are read to their end", () => {
  expect(readAll(stateOf("L X+1 ".repeat(90_000))).field(readingField).program.blocks).toHaveLength(1);
  expect(isRead(stateOf(""))).toBe(true);
});

test("text typed before a long text is fully read is read like the rest", () => {
  const edit = fc.record({
    at: fc.double({ min: 0, max: 1, noNaN: true }),
    near: fc.boolean(),
    drop: fc.nat(90),
    put: fc.constantFrom("", "~", "\n", "7", " ~\n", "14 L X+3\nQ215=1 ;A\n"),
  });
  fc.assert(
    fc.property(fc.array(fc.oneof(fc.constant(null), edit), { minLength: 1, maxLength: 6 }), (steps) => {
      let state = stateOf(long);
      for (const step of steps) {
        if (!step) state = state.update(readFurther).state;
        else {
          const end = state.field(readingField).starts.at(-1) ?? 0;
          const from = step.near
            ? Math.max(0, Math.min(state.doc.length, end - 60 + Math.floor(step.at * 120)))
            : Math.floor(step.at * state.doc.length);
          state = state.update({
            changes: { from, to: Math.min(state.doc.length, from + step.drop), insert: step.put },
          }).state;
        }
      }
      expect(readAll(state).field(readingField).program).toEqual(parse(state.doc.toString()));
    }),
    { numRuns: 15 },
  );
});
