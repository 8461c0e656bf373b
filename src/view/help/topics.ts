import type { ParamTextId } from "../../cycles/index.ts";
import type { Params } from "../../cycles/params.ts";

/** How the picture explains a parameter: by a dimension of the outline, or by what the cycle does with the value. */
export type Topic = "outline" | "element" | "clearance" | "infeed" | "oversizeDiameter" | "oversizeZ" | "roughingFeed" | "finishingFeed"
  | "plungingFeed" | "operation" | "reverse" | "smoothing" | "plunging" | "limits" | "limitDiameter" | "limitZ" | "direction"
  | "offsetWidth" | "depthCompensation";

/** One topic for each text of the catalogue: a parameter without a place in the picture does not compile. */
const topics: Readonly<Record<ParamTextId, Topic>> = {
  operation: "operation",
  clearance: "clearance",
  clearanceReserved: "clearance",
  startDiameter: "outline",
  startZ: "outline",
  endDiameter: "outline",
  endZ: "outline",
  surfaceAngle: "outline",
  faceAngle: "outline",
  flankAngle: "outline",
  secondFlankAngle: "outline",
  startElement: "element",
  startElementSize: "outline",
  endElement: "element",
  endElementSize: "outline",
  cornerRadius: "outline",
  infeedRadial: "infeed",
  infeedAxial: "infeed",
  infeedGroove: "infeed",
  roughingFeed: "roughingFeed",
  oversizeDiameter: "oversizeDiameter",
  oversizeZ: "oversizeZ",
  finishingFeed: "finishingFeed",
  smoothing: "smoothing",
  reverseContour: "reverse",
  plunging: "plunging",
  plungingFeed: "plungingFeed",
  limits: "limits",
  limitDiameter: "limitDiameter",
  limitZ: "limitZ",
  direction: "direction",
  offsetWidth: "offsetWidth",
  depthCompensation: "depthCompensation",
};

/** The topic of a parameter's text; a text the picture does not know is a plain dimension. */
export const topicOf = (text: string): Topic => (topics as Readonly<Record<string, Topic | undefined>>)[text] ?? "outline";

/** The Q of a cycle that a topic belongs to. */
export const qOf = (params: Params, topic: Topic): string | null =>
  Object.entries(params).find(([, p]) => topicOf(p.text) === topic)?.[0] ?? null;

/** The Q of the type that says what a size is (chamfer or radius), or of the size that belongs to a type. */
export function partnerOf(params: Params, q: string): string | null {
  const text = params[q]?.text;
  if (!text) return null;
  const other = text.endsWith("ElementSize") ? text.slice(0, -4) : text.endsWith("Element") ? `${text}Size` : null;
  return other ? (Object.entries(params).find(([, p]) => p.text === other)?.[0] ?? null) : null;
}
