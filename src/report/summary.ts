import { KIND_WORDS } from "../program/clamping/words.ts";
import type { Report, ReportOperation } from "./report.ts";
import type { VerdictReason } from "./verdict.ts";

const fixed = (n: number, decimals: number) => String(Number(n.toFixed(decimals)));

/** Minutes and seconds. */
function minutes(seconds: number): string {
  const whole = Math.round(seconds);
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, "0")}`;
}

const duration = (seconds: number): string => `${minutes(seconds)} min`;

const operationLine = (o: ReportOperation) =>
  `  block ${o.block}: cycle ${o.cycle}, tool ${o.tool["T"]} ${o.tool["NAME"]}, from X${fixed(o.start.x, 3)} Z${fixed(o.start.z, 3)}: ` +
  `${o.passes} passes of ${fixed(o.infeed, 3)} mm, ${o.moves.length} moves, ${duration(o.seconds)}`;

/** Parts that a running time may lack, in words. */
const LACKED = [
  ["acceleration", "acceleration"],
  ["toolChange", "tool changes"],
  ["spindle", "spindle run-up"],
] as const;

/** The running time by category, and the data used for it. */
function timeLine({
  total,
  cutting,
  dwell,
  rapid,
  rates,
  toolChange,
  spindle,
  contains,
  machine,
}: Report["time"]): string {
  const meters = (rate: number) => fixed(rate / 1000, 3);
  const rate =
    typeof rates === "number" ? `${meters(rates)} m/min` : `X ${meters(rates.x)}, Z ${meters(rates.z)} m/min`;
  const parts = [
    `cutting ${minutes(cutting)}`,
    ...(dwell > 0 ? [`dwell ${minutes(dwell)}`] : []),
    `rapid traverse ${minutes(rapid)} at ${rate}`,
    ...(toolChange > 0 ? [`tool changes ${minutes(toolChange)}`] : []),
    ...(spindle > 0 ? [`spindle ${minutes(spindle)}`] : []),
  ];
  const lacked = LACKED.filter(([part]) => !contains.includes(part)).map(([, name]) => name);
  const source = machine === null ? "no machine data" : `machine ${machine}`;
  return `  time ${duration(total)}: ${parts.join(", ")}; ${source}${lacked.length > 0 ? `, without ${lacked.join(", ")}` : ""}`;
}

const many = (n: number, one: string, more: string) => `${n} ${n === 1 ? one : more}`;
const inBlock = (block: number | null) => (block === null ? "" : ` in block ${block}`);

const inFile = (file: string | undefined) => (file === undefined ? "" : ` (${file})`);

const placeInFile = (place: Report["issues"][number]["inFile"]) =>
  place ? `, ${place.file}${place.block === null ? "" : ` block ${place.block}`}` : "";

/** A reason of the verdict in words. */
function because(r: VerdictReason): string {
  switch (r.kind) {
    case "error":
      return `${many(r.count, "error", "errors")} in the program, the first${inBlock(r.block)}${inFile(r.file)}`;
    case "gouge":
      return `contour damage ${fixed(r.area, 3)} mm², first${inBlock(r.block)}`;
    case "rapidInStock":
      return `rapid traverse through ${fixed(r.area, 3)} mm² of stock, first${inBlock(r.block)}`;
    case "holderContact":
      return `holder touches stock, first${inBlock(r.block)}`;
    case "cutOnLoosePiece":
      return `a piece that came loose is cut, first${inBlock(r.block)}`;
    case "rapidBehindBlank":
      return `rapid traverse behind the rear end of the blank, first${inBlock(r.block)}`;
    case "clampContact":
      return `tool or holder touches the clamping, first${inBlock(r.block)}`;
    case "spindleStopped":
      return `the spindle does not turn as it must, first${inBlock(r.block)}`;
    case "toolLimit":
      return `a tool works beyond what its row states, first${inBlock(r.block)}`;
    case "holeMissing":
      return `a hole is missing, first${inBlock(r.block)}`;
    case "unproved":
      return `${r.what} is not simulated: unverified from${r.block === null ? " the beginning" : ` block ${r.block}`}${inFile(
        r.file,
      )} on`;
    case "milling":
      return `milling is not simulated: unverified from block ${r.block} on`;
    case "nothingCut":
      return `the operation in block ${r.block} cut nothing`;
    case "noOperation":
      return "no turning cycle was run";
    case "notes":
      return r.notes.map((note) => NOTES[note]).join(", ");
    case "holderUnknown":
      return `holder not checked: tool ${r.tool} ${r.name} has none`;
    case "flanksUnknown":
      return `flanks not checked: tool ${r.tool} ${r.name} has no T-ANGLE or P-ANGLE`;
    case "curvatureUnknown":
      return `curvature of the blade not checked: tool ${r.tool} ${r.name} plunges along Z, DAXN or DAXX is empty`;
  }
}

const NOTES = {
  feed: "an implausible feed",
  air: "most passes of an operation cut air",
  residue: "more than 1 mm² residual material",
  cutLength: "the cutting edge is too short for the depth",
} as const;
/** "Verified" refers to path and stock only. */
const SEE_NOTES = "Path verified, with notes";
const VERDICTS = { proved: "Verified", faults: "Errors found", incomplete: "Not fully simulated" } as const;

/** The verdict in words, each reason on a line of its own. */
const verdictLines = ({ verdict, reasons }: Report["proof"]) => [
  `  ${verdict === "proved" && reasons.some((r) => r.kind === "notes") ? SEE_NOTES : VERDICTS[verdict]}${reasons.length > 0 ? ":" : ""}`,
  ...reasons.map((r) => `    ${because(r)}`),
];

/** The measured cuts. */
function cutLine({ cut, airPasses, deepest, holder }: Report["proof"]): string {
  const allowed = deepest && (deepest.allowed > 0 ? `${fixed(deepest.allowed, 3)} mm allowed` : "no limit set");
  const depth = deepest ? `, deepest pass ${fixed(deepest.depth, 3)} mm (${allowed})` : "";
  return `  cut ${fixed(cut, 3)} mm²${depth}, ${many(airPasses, "air pass", "air passes")}, holder ${holder}`;
}

/** The clamping; if not stated, contacts with it are not checked. */
const clampingLine = ({ clamping: c }: Report): string =>
  c
    ? `  clamping: ${KIND_WORDS[c.kind].toLowerCase()}, D${fixed(c.diameter, 3)}, front at Z${fixed(c.face, 3)}${
        c.tailstock ? `, tailstock at Z${fixed(c.tailstock.tip, 3)}` : ""
      }`
    : "  clamping not specified: held at the rear end of the blank, contact with jaws, chuck or tailstock not checked";

const leftLine = (r: Report["proof"]["residual"][number]) =>
  `    ${fixed(r.area, 3)} mm², up to ${fixed(r.thickness, 3)} mm thick: ${r.reason}` +
  (r.tools.length > 0 ? `; suitable tools: ${r.tools.join(", ")}` : "");

/** The report as text: verdict, operations, check results, and every finding with its block. */
export function summary(r: Report): string {
  const { gouge, rapidInStock, residual } = r.proof;
  const left = residual.reduce((sum, piece) => sum + piece.area, 0);
  const count = (severity: string) => r.issues.filter((i) => i.severity === severity).length;
  return [
    `${r.file}: ${r.program.name || "(no name)"}, ${r.program.unit}, ${r.program.blocks} blocks`,
    ...verdictLines(r.proof),
    clampingLine(r),
    ...r.operations.map(operationLine),
    `  check: contour damage ${fixed(gouge, 3)} mm², rapid traverse in stock ${fixed(rapidInStock, 3)} mm², residual ` +
      `${fixed(left, 3)} mm² in ${many(residual.length, "place", "places")}`,
    ...residual.map(leftLine),
    cutLine(r.proof),
    timeLine(r.time),
    ...r.issues.map(
      (i) =>
        `  ${i.severity}${i.block === undefined ? "" : ` in block ${i.block}`}${placeInFile(i.inFile)}${
          i.at === undefined ? "" : ` (${i.at})`
        }: ${i.text}`,
    ),
    `  ${count("error")} errors, ${count("warning")} warnings`,
    "",
  ].join("\n");
}
