import { noWords } from "../words.ts";
import { defineBlock } from "./define.ts";
import { functionsField, pathWords } from "./path-words.ts";
import { CONE, cut } from "./sample.ts";

/** The program stops until it is started again. */
export const stop = defineBlock({
  kind: "stop",
  keyword: "STOP",
  words: [pathWords(() => [functionsField], { wide: false })],
  tags: ["leaves"],
  part: "notes",
  offered: { group: "order", begins: { kind: "stop", words: noWords } },
  sample: cut(...CONE, "> STOP"),
});
