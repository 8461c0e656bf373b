import type { FileName } from "../words.ts";
import { parameterOf } from "../value.ts";
import { defineBlock } from "./define.ts";
import { takeFileName } from "./file-name.ts";
import { cut } from "./sample.ts";
import { fileText, textField, word } from "./words.ts";

/** Selects the program with the contour of the next cycle. */
export const selectContour = defineBlock({
  kind: "selectContour",
  keyword: "SEL CONTOUR",
  begins: String.raw`SEL[ \t]+CONTOUR(?![A-Z])`,
  words: [
    word<"file", FileName, "file">("file", {
      take: (scan) => {
        const name = takeFileName(scan);
        return name && !name.bare ? name.file : undefined;
      },
      text: (file) => ` ${fileText(file)}`,
      fields: () => [
        textField<FileName, "file">(
          "file",
          (file) => (typeof file === "object" ? file.parameter : file),
          (typed) => (typed.includes('"') ? undefined : (parameterOf(typed.trim()) ?? typed)),
          { wide: true, noPicture: "name" },
        ),
      ],
    }),
  ],
  tags: ["namesContour"],
  part: "labels",
  offered: { group: "contour", begins: { kind: "selectContour", file: "CONTOUR.H" } },
  sample: cut(`> SEL CONTOUR "CONTOUR.H"`),
});
