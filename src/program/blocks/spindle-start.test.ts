import { describe, expect, test } from "vitest";
import { cycleByNumber } from "../../cycles/index.ts";
import { parse } from "../../nc/parse.ts";
import { exampleDraft } from "../job/read-draft.ts";
import { run } from "../run/run.ts";
import { shippedTools } from "../tools/shipped-tools.ts";

const cycle = cycleByNumber(811);
if (!cycle) throw new Error("no cycle 811");
const DEF = `CYCL DEF 811 SHOULDER, LONGITDNL. ~\n${Object.entries(exampleDraft(cycle))
  .map(([q, v]) => `${q}=${v}`)
  .join(" ~\n")}`;

const stoppedAt = (body: string, frame = "FUNCTION MODE TURN\nTOOL CALL 1\nFUNCTION TURNDATA SPIN VCONST:OFF S731\n") =>
  run(parse(`BEGIN PGM T MM\nBLK FORM CYLINDER Z D76.4 L83 DIST+1\n${frame}M136\n${body}\nM30\nEND PGM T MM\n`), {
    tools: shippedTools,
    rapid: 10_000,
  })
    .issues.filter(({ issue }) => issue.code === "spindleStopped")
    .map(({ line }) => line);
const length = DEF.split("\n").length;
/** Line of the block this many blocks behind the definition. */
const behind = (blocks: number) => 6 + length + blocks;

describe("a call while nothing has started the spindle", () => {
  test("is reported at each call", () => {
    expect(stoppedAt(`${DEF}\nL X+77.3 Z+2.1 FMAX\nCYCL CALL`)).toEqual([behind(2)]);
    expect(stoppedAt(`${DEF}\nL X+77.3 Z+2.1 FMAX\nCYCL CALL\nL X+81.7 Z+4.3 FMAX M99`)).toEqual([
      behind(2),
      behind(3),
    ]);
  });

  test.each(["M3", "M4", "M13", "M14", "M303", "M304"])("%s starts it, in the block itself as well", (m) => {
    expect(stoppedAt(`${DEF}\nL X+77.3 Z+2.1 FMAX ${m}\nCYCL CALL`)).toEqual([]);
    expect(stoppedAt(`${DEF}\nL X+77.3 Z+2.1 FMAX ${m} M99`)).toEqual([]);
  });

  test.each(["M8", "M136", "M91"])("%s does not", (m) => {
    expect(stoppedAt(`${DEF}\nL X+77.3 Z+2.1 FMAX\n${m}\nL X+77.3 Z+2.1 FMAX\nCYCL CALL`)).toEqual([behind(4)]);
  });

  test.each(["M5", "M305"])("%s stops it at the end of its block", (m) => {
    expect(stoppedAt(`${DEF}\nL X+77.3 Z+2.1 FMAX M303\nCYCL CALL ${m}`)).toEqual([]);
    expect(stoppedAt(`${DEF}\nL X+77.3 Z+2.1 FMAX M303\nCYCL CALL ${m}\nL X+77.3 Z+2.1 FMAX\nCYCL CALL`)).toEqual([
      behind(4),
    ]);
  });

  test.each(["M403", "M23", "CALL PGM START.H", "M203 STRANGE"])(
    "%s may have started it, and nothing is reported",
    (block) => {
      expect(stoppedAt(`${block}\n${DEF}\nL X+77.3 Z+2.1 FMAX\nCYCL CALL`)).toEqual([]);
    },
  );

  test("reports a missing speed as well, in turning", () => {
    expect(stoppedAt(`${DEF}\nL X+77.3 Z+2.1 FMAX\nCYCL CALL`, "FUNCTION MODE TURN\nTOOL CALL 1\n")).toEqual([
      behind(1),
    ]);
    expect(
      stoppedAt(`${DEF}\nL X+77.3 Z+2.1 FMAX\nCYCL CALL`, "TOOL CALL 1\nFUNCTION TURNDATA SPIN VCONST:OFF S731\n"),
    ).toEqual([]);
  });
});
