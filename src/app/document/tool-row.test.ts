import { beforeEach, expect, test } from "vitest";
import { shippedList } from "../../program/tools/tool-list.ts";
import { shownPage, usePlace } from "../place/place.ts";
import { editTools, useTools } from "./tool-store.ts";
import { createCalledTool } from "./tool-row.ts";

beforeEach(() => editTools(() => shippedList));

test.each([
  ["42", { T: "42" }],
  ["GROOVE-4", { T: "16", NAME: "GROOVE-4" }],
])("a called tool that the table lacks, %s, gets a row that is shown", (called, cells) => {
  createCalledTool(called);
  const added = useTools.getState().list.at(-1);
  expect(added?.cells).toMatchObject(cells);
  expect(useTools.getState().list).toHaveLength(shippedList.length + 1);
  expect(shownPage(usePlace.getState()).page).toBe("tools");
  expect(usePlace.getState().tools.row).toBe(added?.id);
});
