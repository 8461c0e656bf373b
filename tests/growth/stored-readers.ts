import { CompletionContext } from "@codemirror/autocomplete";
import { EditorState } from "@codemirror/state";
import { deflateSync, strToU8, zipSync } from "fflate";
import { sheetInWorkbook } from "../../src/app/document/workbook-file.ts";
import { completionsAt } from "../../src/app/fields/blocks/cycle-help.ts";
import { readingField } from "../../src/app/fields/blocks/reading-field.ts";
import { termParts } from "../../src/app/fields/said/term-parts.ts";
import { readArchive } from "../../src/app/records/archive.ts";
import { readLink } from "../../src/app/records/link.ts";
import { readTaught } from "../../src/features/course/teach/taught-files.ts";
import { glossary } from "../../src/i18n/en/glossary.ts";
import { workplace } from "../../src/i18n/en/workplace.ts";
import { readTolerance, readToleratedSize } from "../../src/kernel/fit/typed-tolerance.ts";
import { readPart } from "../../src/planning/part/part-file.ts";
import type { Frames, Reader } from "./readers.ts";

/*
 * Readers of what is packed or written as JSON: the repeated text stands in the packed bytes, in the text that is
 * packed, and in a value of it.
 */

const zip = (name: string, text: string) => zipSync({ [name]: strToU8(text) }, { level: 0 });
/** Many empty files: an entry of the directory for each. */
const crowd = (text: string) =>
  zipSync(Object.fromEntries(Array.from({ length: text.length / 8 }, (_, i) => [`${i}`, strToU8("")])), { level: 0 });
const base64 = (text: string) => Buffer.from(deflateSync(strToU8(text), { level: 0 })).toString("base64url");

/** A JSON object around the text: as a string, as a list, and as an object. */
const json = (front: string): Frames => [
  [`${front}"`, '"}'],
  [`${front}[`, "]}"],
  [`${front}{`, "}}"],
];
const JSON_PUMPS = ["{},", '"a",', '"a":1,', "[],", "null,", '{"id":"a"},', "\\n"];

const office = (cells: string) =>
  zipSync(
    {
      "xl/workbook.xml": strToU8('<workbook><sheets><sheet name="A" id="r1"/></sheets></workbook>'),
      "xl/worksheets/sheet1.xml": strToU8(`<worksheet><sheetData>${cells}</sheetData></worksheet>`),
      "xl/sharedStrings.xml": strToU8(`<sst>${cells}</sst>`),
    },
    { level: 0 },
  );
const open = (cells: string) =>
  zip("content.xml", `<office:document-content><table:table>${cells}</table:table></office:document-content>`);

export const STORED: readonly Reader[] = [
  {
    name: "archive",
    read: (text) => [
      readArchive(strToU8(`PK${text}`)),
      readArchive(zip("turnwise.json", text)),
      readArchive(crowd(text)),
    ],
    frames: [
      ...json('{"format":"turnwise-archive/1","works":'),
      ['{"format":"turnwise-archive/1","works":[{"name":"a","content":{"version":3,"savedAt":1,"job":', "}}]}"],
    ],
    pumps: JSON_PUMPS,
  },
  {
    name: "link",
    read: (text) => [readLink(`#h2=${text}`), readLink(`#p=${base64(text)}`), readLink(`#w=${base64(text)}`)],
    frames: [['{"name":"a","encoding":"utf-8","text":"', '"}'], ...json('{"name":"a","draft":')],
    pumps: JSON_PUMPS,
  },
  ...["task", "set", "result"].map((name) => ({
    name: `taught ${name}`,
    read: readTaught,
    frames: [
      ...json(`{"format":"turnwise-${name}/1","tasks":`),
      ...json(`{"format":"turnwise-${name}/1","title":`),
      [`{"format":"turnwise-${name}/1","tasks":[{"id":"a","program":"`, '"}]}'],
    ] as const,
    pumps: JSON_PUMPS,
  })),
  { name: "part file", read: readPart, frames: json('{"format":"turnwise-part/1","contour":'), pumps: JSON_PUMPS },
  {
    name: "workbook",
    read: (text) => [sheetInWorkbook(office(text)), sheetInWorkbook(open(text))],
    frames: [
      ["<row><c>", "</c></row>"],
      ["<si>", "</si>"],
      ["<table:table-row><table:table-cell><text:p>", "</text:p></table:table-cell></table:table-row>"],
    ],
    pumps: [
      "<row><c><v>1</v></c></row>",
      "<row>",
      '<row><c r="ZZ1"/></row>',
      "<table:table-row><table:table-cell>",
      "<table:table>",
      "<si><t>A</t></si>",
      "<r>",
    ],
  },
  {
    name: "tolerance",
    read: (text) => [readTolerance(text, 20), readToleratedSize(text)],
    frames: [
      ["20 ", "!"],
      ["20 +0.1/", "!"],
      ["20 H7/", "!"],
    ],
    pumps: ["H7", "+0.1", "±"],
  },
  {
    name: "terms",
    read: (text) => termParts([text], glossary),
    pumps: ["nose radius ", "Nose ", "feed "],
  },
  {
    name: "completions",
    read: (text) => {
      const state = EditorState.create({ doc: text, extensions: readingField });
      return completionsAt(workplace, "en", new CompletionContext(state, state.doc.length, true));
    },
    frames: [
      ["CYCL DEF 812 A ~\n", "Q2"],
      ["12 ", "A"],
      ["/1 ", "A"],
    ],
    pumps: ["Q200=+1 ~\n", "CALL"],
  },
];
