import { showFile } from "../../document/shown-file.ts";
import type { ShowBlock } from "../../place/place.ts";
import { openBlock, readWhole, sessionView } from "./session.ts";

/** Shows a block of the open program in its text. */
export const showTextBlock: ShowBlock = (file, index) => {
  showFile(file);
  readWhole();
  openBlock(index);
  sessionView()?.focus();
};
