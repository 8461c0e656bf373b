import type { Kind, Param, Topic } from "../../cycles/params.ts";
import type { TermId } from "../../i18n/glossary-text.ts";

const TERMS_OF_KIND: Readonly<Record<Kind, readonly TermId[]>> = {
  choice: [],
  diameter: ["diameter", "contour"],
  oversizeDiameter: ["oversize", "diameter", "finishing"],
  radial: ["radius"],
  axial: ["workpieceZero", "contour"],
  axialDepth: ["infeed", "pass"],
  length: [],
  angle: ["mainEdge"],
  feed: ["feedPerTurn", "roughness", "chip"],
  count: ["pass"],
  factor: [],
  percent: [],
  revolutions: [],
};

const TERMS_OF_TOPIC: Partial<Record<Topic, readonly TermId[]>> = {
  operation: ["roughing", "finishing", "oversize"],
  clearance: ["setupClearance", "rapid", "startPoint"],
  infeed: ["infeed", "pass", "edgeLength"],
  oversizeDiameter: ["oversize"],
  oversizeZ: ["oversize", "finishing", "face"],
  element: ["cornerElement", "shoulder"],
  reverse: ["contour", "theoreticalTip"],
  plunging: ["plunging", "undercut", "secondaryEdge"],
  plungingFeed: ["plunging", "secondaryEdge"],
  limits: ["limit"],
  limitDiameter: ["limit"],
  limitZ: ["limit"],
  smoothing: ["pass", "residue"],
  direction: ["recess", "pass"],
  offsetWidth: ["recess", "noseRadius"],
  depthCompensation: ["recess", "finishing"],
  allowance: ["blank", "oversize"],
  cuttingLines: ["pass", "rapid"],
  depthLimit: ["plunging", "recess", "chip"],
  overlap: ["recess", "noseRadius"],
  solidFeed: ["recess", "feedPerTurn"],
  retraction: ["recess", "rapid"],
  dwell: ["recess"],
  comb: ["recess", "chip"],
  pitch: ["thread", "pitch"],
  threadPosition: ["thread"],
  threadOrientation: ["thread"],
  threadDepth: ["thread", "infeed"],
  taperForm: ["thread"],
  runIn: ["thread", "runIn"],
  infeedType: ["thread", "infeed", "chip"],
  startingAngle: ["thread"],
  threadStarts: ["thread", "pitch"],
  airCuts: ["thread", "pass"],
};

/** The glossary terms that the page of a parameter links to. */
export function termsOf({
  kind,
  shown,
  rounds,
  sizes,
}: Pick<Param, "kind" | "shown" | "rounds" | "sizes">): readonly TermId[] {
  const own: readonly TermId[] = rounds ? ["noseRadius", "theoreticalTip", "residue"] : sizes ? ["cornerElement"] : [];
  const all = [...new Set([...own, ...(TERMS_OF_TOPIC[shown] ?? []), ...TERMS_OF_KIND[kind]])];
  return all.length > 0 ? all : ["contour"];
}
