import type { Shape } from "../shape.ts";

/** Reasons for cutting values, by their formulas, and sizes with a tolerance. Numbers arrive as text. */
export const cuttingValues = {
  reasons: {
    depthOfFeed: "at most 10 × the feed, so that the chip breaks",
    depthOfEdge: "two thirds of the cutting edge",
    depthOfButton: "half the radius of the round insert",
    depthOfPower: "limited by the spindle power",
    depthOfWorkpiece: "limited by the deflection of the workpiece",
    depthOfBar: "limited by the deflection of the boring bar",
    depthOfWidth: "half the insert width",
    depthOfThread: "first pass; all passes cut the same chip cross-section",
    depthOfTooth: "largest first pass of a thread",
    depthOfNose: "two thirds of the tool nose radius: with less the nose rubs",
    depthLeast: "least depth that still cuts",
    oversizeOfNose: "twice the finishing depth: two thirds of the tool nose radius",
    oversizeOfDepth: "twice the finishing depth",
    halfOfDepth: "half the oversize per side",
    stepOfWidth: "deep groove: chip broken after 1.5 × insert width",
    stepOfDiameter: "deep hole: chips cleared after each drill diameter",
    wholeDepth: "in one go",
    feedOfMaterial: "cutting data of the material",
    feedOfNose: "0.8 × tool nose radius",
    feedOfRoughness: "from roughness and tool nose radius",
    feedOfCorner: "at most the corner radius of the insert",
    feedOfWidth: "4 % of the insert width",
    feedOfWorkpiece: "limited by the deflection of the workpiece",
    feedOfBar: "limited by the deflection of the boring bar",
    feedOfPower: "limited by the spindle power",
    feedOfDrill: "by the drill diameter",
    feedOfPitch: "the pitch",
    feedLeast: "least feed that still cuts",
    halfOfFeed: "half the feed",
    speedOfMaterial: "cutting data of the material",
    speedOfShare: "share of the roughing speed of the material",
    rpmOfSpeed: "from cutting speed and diameter",
    rpmOfMachine: "highest spindle speed of the machine",
    rpmAssumed: "machine unknown: assumed limit",
    rpmOfThread: "fastest feed rate of the machine at this pitch",
    limitOfMachine: "highest spindle speed of the machine; cutting speed held down to d",
    limitAssumed: "machine unknown: assumed limit; cutting speed held down to d",
  },
  risks: {
    slenderWorkpiece: (ratio: string) => `The free workpiece is ${ratio} × as long as thick: support it with a centre.`,
    slenderBar: (ratio: string) => `The boring bar is ${ratio} × as long as thick; steel bars up to 4 ×.`,
    deepGroove: (ratio: string) => `The groove is ${ratio} × as deep as the insert is wide; up to 8 ×.`,
    notDrilled: "Hardened steel is not drilled with high-speed steel.",
    edgeUnknown: "CUTLENGTH is empty: the infeed is not limited by the cutting edge.",
  },
  tolerance: {
    middle: (size: string, upper: string, lower: string, sum: string, middle: string) =>
      `${size}: ${upper} / ${lower} mm. Middle: ${sum} = ${middle}`,
    source: "From public tables of ISO 286-1. Not printed for this control.",
  },
};

export type CuttingValueTexts = Shape<typeof cuttingValues>;
