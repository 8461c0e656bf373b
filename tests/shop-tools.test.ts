import { zipSync } from "fflate";
import { describe, expect, test } from "vitest";
import { readShopTools } from "../scripts/shop-tools.ts";

const bytes = (text: string) => new TextEncoder().encode(text);
const SHEET = "Nr;Bezeichnung;Typ;Orientierung;Radius;Einstellwinkel;Spitzenwinkel;Fach\n";

/** Files of `--tools`: what T41 becomes, and words that a note must have. */
const FILES: readonly (readonly [what: string, text: string | Uint8Array, tool: object, notes: readonly RegExp[]])[] = [
  [
    "a sheet with titles of its own",
    `${SHEET}41;Schruppstahl;Schruppen;1;0,8;95;80;A3\n`,
    { T: 41, TYPE: "ROUGH", TO: 1, RS: 0.8, "T-ANGLE": 95, "P-ANGLE": 80 },
    [/Radius as RS/, /not read: Fach/],
  ],
  [
    "a sheet whose titles say inch",
    "No;Type;TO;Nose radius (inch)\n41;ROUGH;1;0.03125\n",
    { T: 41, TYPE: "ROUGH", RS: 0.79375 },
    [/Nose radius \(inch\) as RS/],
  ],
  [
    "a workbook",
    zipSync({
      "content.xml": bytes(
        `<a><table>${[
          ["Nr", "Typ", "TO", "Radius (inch)"],
          ["41", "Schruppen", "1", "0.03125"],
        ]
          .map((row) => `<table-row>${row.map((c) => `<table-cell><p>${c}</p></table-cell>`).join("")}</table-row>`)
          .join("")}</table></a>`,
      ),
    }),
    { T: 41, TYPE: "ROUGH", RS: 0.79375 },
    [/Radius \(inch\) as RS/],
  ],
  [
    "a table of LinuxCNC",
    "T41 P1 X+12.5 Z+3.2 D0.8 I95 J15 Q2 ;rough right\n",
    { T: 41, TYPE: "ROUGH", RS: 0.4 },
    [/does not state its unit/, /proposed TYPE ROUGH/],
  ],
];

describe("a tools file", () => {
  test.each(FILES)("%s", (_, text, tool, notes) => {
    const read = readShopTools("tools", typeof text === "string" ? bytes(text) : text, "mm");
    if ("problem" in read) throw new Error(read.problem);
    expect(read.tools.tools.find(({ T }) => (T as number) === 41)).toMatchObject(tool);
    for (const note of notes) expect(read.notes.join("\n")).toMatch(note);
  });

  test("lengths of a sheet without a unit follow the option", () => {
    const read = readShopTools("tools.csv", bytes("No;Type;TO;RS\n41;ROUGH;1;0.03125\n"), "inch");
    expect("tools" in read && read.tools.tools.find(({ T }) => (T as number) === 41)?.RS).toBeCloseTo(0.79375, 6);
  });

  test("a sheet about something else is refused", () => {
    expect(readShopTools("prices.csv", bytes("Part;Price\nA;3\n"), "mm")).toHaveProperty("problem");
  });
});
