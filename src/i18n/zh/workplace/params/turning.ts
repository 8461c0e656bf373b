import type { SomeParamTexts } from "../../../param-text.ts";

export const turning = {
  reverseAlong: {
    prompt: "逆轮廓(0-2)?",
    printed: false,
    label: "逆轮廓",
    explanation: "轮廓的加工方向。",
    choices: { 0: "沿编程方向", 1: "沿编程方向的反方向", 2: "沿编程方向的反方向，刀尖沿进给方向镜像（方位1按3切削）" },
  },
  flankAngleRadial: {
    prompt: "侧面角度?",
    printed: false,
    label: "侧面角度",
    explanation: "轮廓起点处侧面与旋转轴垂线之间的夹角。槽向槽底变窄。",
  },
  secondFlankAngleRadial: {
    prompt: "第二侧面角度?",
    printed: false,
    label: "第二侧面角度",
    explanation: "轮廓终点处侧面与旋转轴垂线之间的夹角。",
  },
  infeedFace: {
    prompt: "最大切削深度?",
    printed: false,
    label: "最大进刀量",
    explanation: "每刀沿Z轴的最大进刀量。深度均匀分配，因此实际进刀量往往更小，不会留下过薄的最后一刀。",
  },
  infeedContour: {
    prompt: "最大切削深度?",
    printed: false,
    label: "最大进刀量",
    explanation:
      "每刀最大进刀量（半径值）。深度均匀分配，因此实际进刀量往往更小，不会留下过薄的最后一刀。0：一刀完成。",
  },
  plungeAngle: {
    prompt: "侧面角度?",
    printed: false,
    label: "侧面角度",
    explanation: "轮廓起点处侧面与旋转轴垂线之间的夹角。侧面从轮廓起点向加工区内下降，不会到棱边之后。",
  },
  plungeAngleFace: {
    prompt: "侧面角度?",
    printed: false,
    label: "侧面角度",
    explanation: "轮廓起点处侧面与旋转轴平行线之间的夹角。侧面从轮廓起点向加工区内下降，不会到棱边之后。",
  },
} satisfies SomeParamTexts;
