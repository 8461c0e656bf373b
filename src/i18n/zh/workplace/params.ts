import type { ParamsTexts } from "../../param-text.ts";
import { turning } from "./params/turning.ts";
import { recessing } from "./params/recessing.ts";
import { threads } from "./params/threads.ts";
import { special } from "./params/special.ts";

const printed = true;
/** Prompts that no Chinese page we have prints, worded in the style of the printed ones. */
const unprinted = false;
const element = { 0: "无元素", 1: "倒角", 2: "圆角" };

export const params = {
  operation: {
    prompt: "加工操作(0/1/2/3)?",
    printed,
    label: "加工操作",
    explanation: "循环的加工范围：粗加工、精加工或完整加工。",
    choices: { 0: "粗加工和精加工", 1: "仅粗加工", 2: "仅精加工至最终尺寸", 3: "仅精加工至余量" },
  },
  clearance: {
    prompt: "安全高度?",
    printed,
    label: "安全高度",
    explanation: "预定位和退刀时刀具与材料之间的距离。",
  },
  clearanceReserved: {
    prompt: "安全高度?",
    printed,
    label: "安全高度（保留）",
    explanation: "保留：该值在本循环中不起作用，退刀使用固定距离。",
  },
  startDiameter: {
    prompt: "轮廓起点直径?",
    printed: unprinted,
    label: "起点 ⌀",
    explanation: "轮廓起点的X坐标（直径值）。大于Q493：外尺寸加工；小于Q493：内尺寸加工。",
  },
  startZ: {
    prompt: "轮廓起点Z坐标?",
    printed: unprinted,
    label: "起点 Z",
    explanation: "轮廓起点的Z坐标。",
  },
  endDiameter: {
    prompt: "轮廓终点直径?",
    printed: unprinted,
    label: "终点 ⌀",
    explanation: "轮廓终点的X坐标（直径值）。与起点一起决定外尺寸加工还是内尺寸加工。",
  },
  endZ: {
    prompt: "轮廓终点Z坐标?",
    printed: unprinted,
    label: "终点 Z",
    explanation: "轮廓终点的Z坐标。",
  },
  surfaceAngle: {
    prompt: "圆周面角度?",
    printed: unprinted,
    label: "圆周面角度",
    explanation: "圆周面与旋转轴之间的夹角；0为圆柱面。该面只向加工区内倾斜，不会低于轮廓。",
  },
  flankAngle: {
    prompt: "侧面角度?",
    printed: unprinted,
    label: "侧面角度",
    explanation: "轮廓起点处侧面与旋转轴平行线之间的夹角。槽向槽底变窄。",
  },
  faceAngle: {
    prompt: "端面角度?",
    printed: unprinted,
    label: "端面角度",
    explanation: "端面的倾斜角；0为垂直于旋转轴。端面向加工区内倾斜。",
  },
  secondFlankAngle: {
    prompt: "第二侧面角度?",
    printed: unprinted,
    label: "第二侧面角度",
    explanation: "轮廓终点处侧面与旋转轴平行线之间的夹角。",
  },
  startElement: {
    prompt: "起始元素类型(0/1/2)?",
    printed: unprinted,
    label: "起始元素",
    explanation: "轮廓起点处棱边的元素。",
    choices: element,
  },
  startElementSize: {
    prompt: "起始元素尺寸?",
    printed: unprinted,
    label: "起始元素尺寸",
    explanation: "轮廓起点处倒角的边长或圆角半径。无元素（Q501 = 0）时不起作用。",
  },
  cornerRadius: {
    prompt: "轮廓角半径?",
    printed: unprinted,
    label: "轮廓角半径",
    explanation: "轮廓内角的半径。0或不输入：尖角，角内保留刀尖半径。",
  },
  endElement: {
    prompt: "终止元素类型(0/1/2)?",
    printed: unprinted,
    label: "终止元素",
    explanation: "轮廓终点处棱边的元素。",
    choices: element,
  },
  endElementSize: {
    prompt: "终止元素尺寸?",
    printed: unprinted,
    label: "终止元素尺寸",
    explanation: "轮廓终点处倒角的边长或圆角半径。无元素（Q503 = 0）时不起作用。",
  },
  infeedRadial: {
    prompt: "最大切削深度?",
    printed,
    label: "最大进刀量",
    explanation: "每刀最大进刀量（半径值）。深度均匀分配，因此实际进刀量往往更小，不会留下过薄的最后一刀。",
  },
  infeedAxial: {
    prompt: "最大切削深度?",
    printed,
    label: "最大进刀量",
    explanation: "每刀沿Z轴的最大进刀量。深度均匀分配，因此实际进刀量往往更小，不会留下过薄的最后一刀。0：一刀完成。",
  },
  infeedGroove: {
    prompt: "最大切削深度?",
    printed,
    label: "最大进刀量",
    explanation: "每刀沿Z轴的最大进刀量，均匀分配。手册写为径向，但轴向槽沿Z轴进刀；未验证。",
  },
  roughingFeed: {
    prompt: "粗加工进给速率?",
    printed,
    label: "粗加工进给",
    explanation: "粗加工的进给速率：编程M136时为毫米/转，否则为毫米/分钟。FAUTO取刀具调用中的进给速率。",
  },
  oversizeDiameter: {
    prompt: "直径余量?",
    printed,
    label: "直径余量",
    explanation: "直径上留给精加工的余量，每侧留一半。",
  },
  oversizeZ: {
    prompt: "Z轴方向余量?",
    printed,
    label: "Z余量",
    explanation: "端面上沿Z轴留给精加工的余量。",
  },
  finishingFeed: {
    prompt: "精加工进给率?",
    printed,
    label: "精加工进给",
    explanation: "精加工的进给速率：编程M136时为毫米/转，否则为毫米/分钟。FAUTO取刀具调用中的进给速率。",
  },
  smoothing: {
    prompt: "轮廓平滑(0/1/2)?",
    printed,
    label: "轮廓平滑",
    explanation: "如何去除各刀之间的台阶，以及如何退刀。",
    choices: { 0: "每刀后沿轮廓（进刀区内）", 1: "最后一刀后沿整个轮廓；45°退刀", 2: "不平滑；45°退刀" },
  },
  reverseContour: {
    prompt: "逆轮廓(0-2)?",
    printed,
    label: "逆轮廓",
    explanation: "轮廓的加工方向。",
    choices: { 0: "沿编程方向", 1: "沿编程方向的反方向", 2: "沿编程方向的反方向，刀尖沿进给方向镜像（方位1按7切削）" },
  },
  plunging: {
    prompt: "允许切入(0/1)?",
    printed,
    label: "切入",
    explanation: "是否加工切入轮廓元素。",
    choices: { 0: "不加工切入元素", 1: "加工切入元素" },
  },
  plungingFeed: {
    prompt: "切入进给速率(0=自动)?",
    printed,
    label: "切入进给",
    explanation: "加工切入元素时的进给速率。0或不输入：使用车削进给速率。",
  },
  limits: {
    prompt: "加工极限(0/1)?",
    printed,
    label: "加工极限",
    explanation: "将加工的轮廓限制在Q480和Q482的一侧，即循环调用时刀具所在的一侧。接近和离开路径可跨越极限。",
    choices: { 0: "无极限", 1: "极限为Q480和Q482" },
  },
  limitDiameter: {
    prompt: "直径极限值?",
    printed,
    label: "极限 ⌀",
    explanation: "X轴极限（直径值）。Q479 = 1时有效。",
  },
  limitZ: {
    prompt: "Z轴切削极限值?",
    printed,
    label: "极限 Z",
    explanation: "Z轴极限。Q479 = 1时有效。",
  },
  direction: {
    prompt: "加工方向(0=双向/1=单向)?",
    printed: unprinted,
    label: "加工方向",
    explanation: "各刀是否双向交替切削。",
    choices: { 0: "双向", 1: "单向，沿轮廓方向" },
  },
  offsetWidth: {
    prompt: "偏移宽度?",
    printed: unprinted,
    label: "偏移宽度",
    explanation:
      "从第二次进刀起缩短每次切削，以减小刀片的侧向负荷。0：每刀0.1毫米。侧壁上的残余材料在粗加工结束时切除。每侧总和可达有效宽度的80%。",
  },
  depthCompensation: {
    prompt: "精加工深度补偿?",
    printed: unprinted,
    label: "深度补偿",
    explanation: "移动精加工的槽底，补偿刀片横向车削时的倾斜：正值使槽变浅，负值使槽变深。",
  },
  ...turning,
  ...recessing,
  ...threads,
  ...special,
} satisfies ParamsTexts;
