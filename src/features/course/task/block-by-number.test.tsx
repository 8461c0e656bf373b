import { afterEach, expect, test } from "vitest";
import { closeSession, openBlock, openSession, sessionView } from "../../../app/fields/blocks/session.ts";
import { openFirstWork, useEditor } from "../../../app/document/store.ts";
import { subscribePointedBlock } from "./block-by-number.ts";

const TEXT = "0 BEGIN PGM A MM\n4 L X+41.3 Z-3.25 FMAX\n7 M30\n9 END PGM A MM\n";
let stop = () => undefined as void;
afterEach(() => {
  stop();
  closeSession();
});

test("a block is reported when it is pointed at, not when its text is loaded late or again", () => {
  const told: number[] = [];
  openFirstWork({ name: "A.h", text: TEXT, encoding: "utf-8" }, "w");
  const { program } = useEditor.getState();
  if (!program) throw new Error("no program is open");
  stop = subscribePointedBlock((block) => told.push(block));
  openSession(program, "w");
  expect(told).toEqual([]);
  openBlock(2, null);
  expect(told).toEqual([7]);
  openSession(program, "w");
  expect(told).toEqual([7]);
  sessionView()?.dispatch({ selection: { anchor: 0 }, userEvent: "select.pointer" });
  expect(told.at(-1)).toBe(0);
});
