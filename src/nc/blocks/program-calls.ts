import type { FileName } from "../words.ts";
import { defineBlock, type BlockReading } from "./define.ts";
import { takeFileName } from "./file-name.ts";
import { fileText, property } from "./words.ts";

/** `bare`: the name has no quotes. */
const words = [property<FileName>()("file"), property<boolean>()("bare")] as const;

function read({ scan }: BlockReading) {
  const name = takeFileName(scan);
  if (name) scan.leftOver();
  return name;
}
/** Quotes and case are ignored. */
const plain = (lead: string, file: FileName) => `${lead} ${fileText(file)}`.toUpperCase();

/** Calls another program. */
export const callProgram = defineBlock({
  kind: "callProgram",
  keyword: "CALL PGM",
  begins: String.raw`CALL[ \t]+PGM(?![A-Z])`,
  words,
  read: (reading) => {
    const name = read(reading);
    return name && { kind: "callProgram", ...name };
  },
  print: (s) => `CALL PGM ${fileText(s.file, s.bare)}`,
  isTypedAsText: () => true,
  compareAs: (s, said) => void said.put("", plain("CALL PGM", s.file)),
  tags: ["calls"],
  part: "labels",
});

/** Names the program that CALL SELECTED PGM runs. */
export const selectProgram = defineBlock({
  kind: "selectProgram",
  keyword: "SEL PGM",
  begins: String.raw`SEL[ \t]+PGM(?![A-Z])`,
  words,
  read: (reading) => {
    const name = read(reading);
    return name && { kind: "selectProgram", ...name };
  },
  print: (s) => `SEL PGM ${fileText(s.file, s.bare)}`,
  isTypedAsText: () => true,
  compareAs: (s, said) => void said.put("", plain("SEL PGM", s.file)),
  part: "labels",
});

/** Calls the selected program. */
export const callSelected = defineBlock({
  kind: "callSelected",
  keyword: "CALL SELECTED PGM",
  begins: String.raw`CALL[ \t]+SELECTED[ \t]+(?:PGM|PROGRAM)|CALL[ \t]+SELECTED(?![ \t]*\S)`,
  words: [],
  tags: ["calls"],
  part: "labels",
});
