import { ncLabels } from "../src/i18n/nc-labels.ts";
import { printJob } from "../src/program/job/print-job.ts";
import { printedExample } from "./long-contour.ts";

/** Characters of a program of 10 MB. */
const TEN_MB = 10_000_000;
const HEAD = [
  "BEGIN PGM LARGE MM",
  "BLK FORM CYLINDER Z D100 L200 DIST+0",
  "FUNCTION MODE TURN",
  "TOOL CALL 1",
  "FUNCTION TURNDATA SPIN VCONST:ON VC:180 SMAX2500",
  "M136",
  "L X+104 Z+2 R0 FMAX M303",
];
const TAIL = ["M30", "END PGM LARGE MM"];

const numbered = (blocks: readonly string[]) => blocks.map((b, i) => `${i} ${b}\n`).join("");
const program = (body: readonly string[], behind: readonly string[] = []) =>
  numbered([...HEAD, ...body, "M30", ...behind, TAIL[1] ?? ""]);
const times = <T>(count: number, line: (i: number) => T): T[] => Array.from({ length: count }, (_, i) => line(i));

/** A tip that moves up and down along the part, a little deeper each time: every move cuts. */
const zigzag = (i: number) => {
  const [lap, at] = [Math.floor(i / 400), i % 400];
  const along = lap % 2 === 0 ? at : 399 - at;
  return `L X+${(99 - lap * 0.05 + (i % 2) * 0.04).toFixed(3)} Z-${(along * 0.25 + 0.011).toFixed(3)}${i === 0 ? " F0.2" : ""}`;
};
/** Every move is a rapid that cuts: a finding for each. */
const rapids = (i: number) => `${zigzag(i).replace(" F0.2", "")} FMAX`;

/** The definition of a printed cycle with other values. */
function cycle(number: number, values: Readonly<Record<string, string>>): string {
  const printed = printJob(printedExample(number), ncLabels("en"));
  const found = new RegExp(String.raw`CYCL DEF ${number}[\s\S]*?(?=\r?\n\d+ )`).exec(printed)?.[0] ?? "";
  return Object.entries(values).reduce(
    (text, [q, value]) => text.replace(new RegExp(`${q}=[^ ;~]*`), `${q}=${value}`),
    found,
  );
}

/** A shoulder of 3 mm from a diameter, roughed in a number of passes. */
const shoulder = (from: number, passes: number) =>
  cycle(812, {
    Q491: `+${from}`,
    Q493: `+${from - 6}`,
    Q494: "-150",
    Q495: "+0",
    Q501: "+0",
    Q503: "+0",
    Q463: `+${(3 / passes).toFixed(5)}`,
    Q215: "+1",
    Q460: "+0.5",
  });

/** Operations with a number of passes each, each on the material that the previous one left. */
const passes = (operations: number, each: number) =>
  program(times(operations, (i) => [shoulder(100 - i * 6, each), `L X+${100 - i * 6} Z+2 FMAX`, "CYCL CALL"]).flat());

/** Moves of a pass, and the other moves of an operation. */
const [MOVES_OF_PASS, MOVES_BESIDE] = [5, 10];

/**
 * A grown program: operations that rough and finish ever smaller and shorter shoulders, each on the material that the
 * previous one left and with its share of the moves.
 */
export function grownProgram(operations: number, moves: number): string {
  const step = 80 / operations,
    count = Math.max(1, Math.round((moves / operations - MOVES_BESIDE) / MOVES_OF_PASS));
  // The control has thousandths: the remainder of the division is left for finishing.
  const infeed = Math.max(1, Math.floor((500 * step) / count)) / 1000,
    oversize = step - 2 * infeed * count;
  return program(
    times(operations, (i) => {
      const from = 100 - i * step;
      const values = {
        Q491: `+${from.toFixed(3)}`,
        Q493: `+${(from - step).toFixed(3)}`,
        Q494: `-${(150 - (i * 120) / operations).toFixed(3)}`,
        Q495: "+0",
        Q500: "+0",
        Q501: "+0",
        Q503: "+0",
        Q483: `+${oversize.toFixed(3)}`,
        Q484: "+0.1",
        Q463: `+${infeed.toFixed(3)}`,
        Q215: "+0",
        Q460: "+0.5",
      };
      return [cycle(812, values), `L X+${from.toFixed(3)} Z+2 FMAX`, "CYCL CALL"];
    }).flat(),
  );
}

/**
 * A plate with a square contour that is milled after an approach, and a face that is roughed in many short cuts at
 * three depths.
 */
export function milledProgram(cuts: number): string {
  const rows = Math.ceil(cuts / 3 / 20);
  const row = (i: number) => {
    const [depth, y] = [Math.floor(i / rows), 12 + ((i % rows) * 76) / rows];
    return times(20, (k) => {
      const x = 12 + (i % 2 === 0 ? k : 19 - k) * 4;
      return `L X+${x} Y+${(y + (k % 2) * 0.7).toFixed(3)}${i % rows === 0 && k === 0 ? ` Z-${1 + depth}` : ""} F900`;
    });
  };
  return numbered([
    "BEGIN PGM MILLED MM",
    "BLK FORM 0.1 Z X+0 Y+0 Z-20",
    "BLK FORM 0.2 X+100 Y+100 Z+0",
    "TOOL DEF 1 L+0 R+3",
    "TOOL CALL 1 Z S4000",
    "L X-10 Y-10 R0 FMAX",
    "L Z-5 R0 F1000 M3",
    "APPR LT X+5 Y+5 LEN10 RL F300",
    "L Y+95",
    "L X+95",
    "L Y+5",
    "L X+5",
    "DEP LT LEN10 F1000",
    "L Z+2 FMAX",
    ...times(rows * 3, row).flat(),
    "L Z+50 FMAX",
    "M30",
    "END PGM MILLED MM",
  ]);
}

const untilFull = (line: (i: number) => string) => {
  const lines: string[] = [];
  for (let size = 0; size < TEN_MB;) {
    const next = line(lines.length);
    lines.push(next);
    size += next.length + 8;
  }
  return lines;
};

/**
 * Programs at the limits of reading, running and simulating: by size, by blocks, by moves, by passes, by loops and by
 * faults.
 */
export const largePrograms = {
  "10 MB of cuts": () => program(untilFull(zigzag)),
  "10 MB of rapids in stock": () => program(untilFull(rapids)),
  "10 MB of milling": () =>
    numbered([
      "BEGIN PGM LARGE MM",
      "BLK FORM 0.1 Z X+0 Y+0 Z-20",
      "BLK FORM 0.2 X+100 Y+100 Z+0",
      "TOOL CALL 1 Z S3000",
      "L X-10 Y-10 Z-5 R0 FMAX",
      ...untilFull((i) => `L X+${(i % 997) / 10} Y+${(i % 773) / 10}${i === 0 ? " F500" : ""}`),
      ...TAIL,
    ]),
  "10 MB of milling with RL": () =>
    numbered([
      "BEGIN PGM LARGE MM",
      "BLK FORM 0.1 Z X+0 Y+0 Z-20",
      "BLK FORM 0.2 X+100 Y+100 Z+0",
      "TOOL DEF 1 L+0 R+5",
      "TOOL CALL 1 Z S3000",
      "L X-10 Y-10 Z-5 R0 FMAX",
      ...untilFull(
        (i) => `L X+${((i * 0.01) % 1000).toFixed(3)} Y+${((i % 2) * 0.01).toFixed(3)}${i === 0 ? " RL F500" : ""}`,
      ),
      ...TAIL,
    ]),
  "10 MB of turning with RR": () =>
    program(
      untilFull((i) =>
        i === 0
          ? "L X+96 Z-0.01 RR F0.2"
          : `L X+${(96 + (i % 2) * 0.01).toFixed(3)} Z-${(i * 0.0005 + 0.011).toFixed(4)}`,
      ),
    ),
  "10 MB of nonsense": () => program(untilFull((i) => `HEIDENHAIN what ever ${i}`)),
  "10 MB of broken words": () => program(untilFull((i) => `L X+${i}.5.5 Z-1 Q`)),
  "10 MB of unset parameters": () => program(untilFull((i) => `L X+Q${i % 1000} Z-Q${i % 999} F0.2`)),
  "10 MB of comments": () => program(untilFull((i) => `; comment ${i}`)),
  "10 MB without numbers": () => [...HEAD, ...untilFull(zigzag), ...TAIL].join("\n"),
  "10 MB in one line": () => program([`L ${"X+1 ".repeat(TEN_MB / 4)}`]),
  "10 MB in one cycle": () =>
    program([`CYCL DEF 812 X ~\n${times(TEN_MB / 20, (i) => `Q${(i % 900) + 100}=+1.5 ;X~`).join("\n")}`]),
  "10 MB of labels": () => program(untilFull((i) => `LBL "PART ${i}"`)),
  "10 MB of unknown cycles": () =>
    program(untilFull((i) => (i % 2 === 0 ? `CYCL DEF 811 X ~\nQ460=+${i}` : "CYCL CALL"))),
  "10 MB of corners": () => program(untilFull((i) => (i % 2 === 0 ? zigzag(i) : "RND R0.003"))),
  "200,000 blocks": () => program(times(200_000 - 10, zigzag)),
  "400,000 moves": () => program([shoulder(100, 930), "LBL 1", "L X+100 Z+2 FMAX", "CYCL CALL", "CALL LBL 1 REP 99"]),
  "loop of short moves": () =>
    program(["LBL 1", "L IX-0.001 F0.2", "L IZ-0.001", "L IX+0.0009", "L IZ-0.0001", "CALL LBL 1 REP 60000"]),
  "endless loop": () => program(["LBL 1", "L IX-0.0001 F0.2", "L IZ-0.0001", "CALL LBL 1 REP 999999999"]),
  "endless recursion": () => program(["LBL 1", "L IX-0.0001 F0.2", "CALL LBL 1", "L IZ-0.0001", "CALL LBL 1", "LBL 0"]),
  "loop of cycles": () => program([cycle(812, {}), "LBL 1", "CYCL CALL", "CALL LBL 1 REP 65534"]),
  "loop of free contours": () =>
    program(
      [
        "CYCL DEF 14.0 CONTOUR",
        "CYCL DEF 14.1 LABEL 2",
        cycle(820, {}),
        "LBL 1",
        "L X+75 Z+2 FMAX",
        "CYCL CALL",
        "CALL LBL 1 REP 65534",
      ],
      ["LBL 2", "L X+75 Z-20", "L X+50", "RND R2", "L X+20 Z-25", "RND R2", "L Z+0", "LBL 0"],
    ),
  "contour of 20,000 elements": () =>
    program(
      ["CYCL DEF 14.0 CONTOUR", "CYCL DEF 14.1 LABEL 2", cycle(820, { Q463: "+1" }), "L X+204 Z+2 FMAX", "CYCL CALL"],
      [
        "LBL 2",
        ...times(
          19_990,
          (i) => `L X+${(100 - i * 0.004).toFixed(4)} Z-${(30 - i * 0.001 + (i % 2) * 0.002).toFixed(4)}`,
        ),
        "LBL 0",
      ],
    ),
  "10,000 passes": () => passes(10, 1000),
  "12,000 passes": () => passes(8, 1500),
} satisfies Record<string, () => string>;
