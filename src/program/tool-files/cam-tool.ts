import { HOLDER_STYLES } from "../iso-codes/holder-facts.ts";
import { INSERT_SHAPES } from "../iso-codes/insert-facts.ts";
import type { Hand } from "../iso-codes/code-part.ts";
import type { LengthUnit } from "../../kernel/units.ts";
import {
  PropertyReader,
  type Fact,
  type Facts,
  type FileProperties,
  type FileTool,
  type FileToolKind,
  type RefusalReason,
  type RefusedItem,
  type Vocabulary,
  type WorkSide,
} from "./facts.ts";

/*
 * Tools of Autodesk's CAM (Fusion, Inventor CAM, HSMWorks). JSON and .tools, .hsmlib and the exported sheet name the
 * same properties in three ways; all of them are turned into one map with these names: geometry.RE, insert.corner-radius,
 * tool_cornerRadius. Sources: docs/decisions, tool files of other systems.
 */

const VOCABULARY: Vocabulary = {
  nose: [
    ...["geometry.RE", "insert.corner-radius", "tool_cornerRadius"],
    ...["geometry.thread-tip-radius", "tool_threadTipRadius"],
  ],
  circle: ["geometry.INSC", "geometry.IC"],
  point: ["geometry.EPSR", "insert.tip-angle", "tool_insertAngle"],
  width: [
    "geometry.tool_grooveWidth",
    "geometry.CW",
    "insert.groove-width",
    "tool_grooveWidth",
    "geometry.tool_insertWidth",
  ],
  profile: ["geometry.thread-profile-angle", "body.thread-profile-angle", "tool_threadProfileAngle"],
  pitch: ["geometry.TP", "body.thread-pitch", "tool_threadPitch"],
  cutter: ["geometry.DC", "body.diameter", "tool_diameter"],
  drillPoint: ["geometry.SIG", "body.tip-angle", "tool_tipAngle"],
  flute: ["geometry.LCF", "body.flute-length", "tool_fluteLength"],
  shank: ["holder.W", "holder.shankWidth", "turning-holder.shank-width", "tool_shankWidth"],
  reach: ["holder.CW", "holder.cuttingWidth", "turning-holder.cutting-width", "tool_cuttingWidth"],
  head: ["holder.LH", "holder.headLength", "turning-holder.head-length", "tool_holderHeadLength"],
  overall: ["holder.OAL", "holder.overallLength", "turning-holder.overall-length", "tool_holderOverallLength"],
};
/** Sizes that only some kinds have; a library keeps defaults of the others. */
const OF_KIND: Readonly<Record<FileToolKind, readonly (keyof Vocabulary)[]>> = {
  turning: ["nose", "circle", "point", "shank", "reach", "head", "overall"],
  grooving: ["nose", "width", "shank", "reach", "head", "overall"],
  parting: ["nose", "width", "shank", "reach", "head", "overall"],
  threading: ["nose", "profile", "shank", "reach", "head", "overall"],
  drill: ["cutter", "drillPoint", "flute"],
  center: ["cutter", "drillPoint", "flute"],
  tap: ["cutter", "pitch", "flute"],
  reamer: ["cutter", "flute"],
  mill: ["cutter"],
};

/** Kinds of the library by name, and of what is no tool of a lathe's table. */
const KINDS: Readonly<Record<string, FileToolKind | RefusalReason>> = {
  "turning general": "turning",
  "turning boring": "turning",
  "turning custom": "turning",
  "turning grooving": "grooving",
  "turning parting": "parting",
  "turning threading": "threading",
  "turning drill": "drill",
  "turning drilling": "drill",
  "turning tap": "tap",
  drill: "drill",
  "block drill": "drill",
  "center drill": "center",
  "spot drill": "center",
  "tap right hand": "tap",
  "tap left hand": "tap",
  reamer: "reamer",
  "end mill": "mill",
  "slot mill": "mill",
  probe: "probe",
  holder: "holder",
  "tool block": "holder",
  waterjet: "otherMachine",
  "laser cutter": "otherMachine",
  "plasma cutter": "otherMachine",
};
const kindOf = (type: string): FileToolKind | RefusalReason =>
  KINDS[type] ?? (/\bmill$/.test(type) || type.startsWith("circle segment") ? "mill" : "noColumn");
const isKind = (kind: FileToolKind | RefusalReason): kind is FileToolKind => kind in OF_KIND;

/** Properties that describe no geometry of the edge. */
const IDLE = [
  ...["geometry.NOF", "geometry.NT", "geometry.CSP", "geometry.OAL", "geometry.LB", "geometry.SFDM", "geometry.NOP"],
  ...["geometry.assemblyGaugeLength", "geometry.shoulder-length", "geometry.shoulder-diameter", "geometry.HAND"],
  ...["geometry.S", "geometry.TC", "geometry.SCTY", "geometry.RA", "geometry.SIZE_SPECIFICATION_MODE", "holder.MTP"],
  ...["holder.H", "geometry.tool_internalThread", "geometry.thread-tip-type", "geometry.tip-diameter", "holder.SYTY"],
];

function handOf(reader: PropertyReader): Fact<Hand> | undefined {
  const said = reader.text("holder.HAND", "holder.hand", "turning-holder.hand", "tool_hand");
  const letter = /^'?(?:(R)(?:ight.*)?|(L)(?:eft.*)?|(N)(?:eutral.*)?)'?$/i.exec(said?.value ?? "");
  const hand = letter
    ?.slice(1)
    .find((each) => each !== undefined)
    ?.toUpperCase() as Hand | undefined;
  return said && hand ? { value: hand, from: said.from } : undefined;
}

interface Style {
  readonly side?: Fact<WorkSide>;
  readonly setting?: Fact<number>;
}

/** The style of a holder: a letter of ISO 5608, a bar with such a letter, or a word such as "groove internal". */
function styleOf(reader: PropertyReader, kind: FileToolKind): Style {
  const said = reader.text("holder.THSC", "holder.style", "turning-holder.style", "tool_holderType");
  const lead = reader.number("holder.tool_leadingAngle", "tool_leadingAngle");
  const style = said?.value.toLowerCase().replace(/['"_]/g, " ").trim() ?? "";
  const found = /^(?:(boring bar)\s+)?(?:iso\s+)?([a-y])$/.exec(style);
  const bar = found?.[1] !== undefined || style.includes("boring bar");
  const side = /\b(internal|external|face)\b/.exec(style)?.[1];
  const sides: Readonly<Record<string, WorkSide>> = { internal: "inside", external: "outside", face: "face" };
  const where = bar ? "inside" : (sides[side ?? ""] ?? (found ? "outside" : null));
  const letter = HOLDER_STYLES[(found?.[2] ?? "").toUpperCase()];
  const cuts = letter && letter.cuts !== (bar ? "side" : "end");
  return {
    ...(said && where && { side: { value: where, from: said.from } }),
    ...(kind === "turning" && said && letter && cuts
      ? { setting: { value: letter.angle, from: said.from, ...(!letter.sure && { why: "unsureStyle" as const }) } }
      : lead && kind === "turning" && { setting: { value: 90 - lead.value, from: lead.from } }),
  };
}

function shapeOf(reader: PropertyReader, kind: FileToolKind): Facts {
  const said = reader.text("geometry.SC", "geometry.SHAPE", "insert.shape", "tool_insertType");
  const letter = /^'?(?:iso\s+)?([a-z])'?$/i.exec(said?.value ?? "")?.[1]?.toUpperCase() ?? "";
  const shape: Facts = said && INSERT_SHAPES[letter] ? { shape: { value: letter, from: said.from } } : {};
  if (kind !== "turning") return {};
  const mode = reader.text("geometry.SIZE_SPECIFICATION_MODE", "tool_insertSizeSpecificationMode")?.value ?? "";
  const size = reader.length(["geometry.INSD", "insert.diameter", "tool_insertSize"]);
  if (!size) return shape;
  if (/^CE$|edge/i.test(mode)) return { ...shape, edge: size };
  return { ...shape, circle: /^IC$|circle/i.test(mode) ? size : { ...size, why: "circleAssumed" } };
}

/** A tool of such a library, or why it is none; `type` is its kind as the library names it. */
export function camTool(
  properties: FileProperties,
  unit: LengthUnit,
  about: { readonly type: string; readonly description: string; readonly product: string },
): FileTool | RefusedItem {
  const [type, description] = [about.type.trim().toLowerCase(), about.description.trim()];
  const label = description === "" ? about.product.trim() || type : description;
  const kind = kindOf(type);
  if (!isKind(kind)) return { label, why: kind, kind: type };
  const reader = new PropertyReader(properties, unit);
  const number = reader.number("post-process.number", "nc.number", "tool_number");
  const hand = handOf(reader);
  const { side, setting } = styleOf(reader, kind);
  // The tip angle of a centre drill is that of its pilot, which no column has.
  const names = OF_KIND[kind].filter((name) => type !== "center drill" || name !== "drillPoint");
  const wanted = Object.fromEntries(names.map((name) => [name, VOCABULARY[name] ?? []]));
  const inner = reader.text("geometry.tool_internalThread", "insert.internal-thread", "tool_internalThread");
  const isInner = /^(?:true|1|yes)$/i.test(inner?.value ?? "");
  reader.pass(...IDLE);
  const sizes = reader.sizes(wanted);
  const inside: Fact<WorkSide> | undefined =
    type === "turning boring"
      ? { value: "inside", from: type }
      : isInner && inner
        ? { value: "inside", from: inner.from }
        : side;
  const named = description !== "" && { name: { value: description, from: description } };
  const facts: Facts = {
    ...(number && { number }),
    ...named,
    kind: { value: kind, from: type },
    ...(inside && { side: inside }),
    ...(hand && { hand }),
    ...(setting && { setting }),
    ...shapeOf(reader, kind),
    ...sizes,
    ...(type === "center drill" && sizes.cutter && { cutter: { ...sizes.cutter, why: "bodyAsCentre" as const } }),
  };
  const unused = reader.unused.filter((name) => !/^(?:post-process|nc)\.|^(?:tool|holder|preset|use_tool)_/.test(name));
  return { label, facts, texts: [about.product, description].filter((text) => text !== ""), unused };
}
