import type { Sentences } from "../../../message-texts.ts";

const RULES = {
  signOfAngle: (word: string) => `角度与DR的正负号不一致（${word}）：数控系统拒绝该圆弧。请使两者符号相同。`,
  zeroBehindCorner: (word: string) => `${word}之后的此程序段长度为0：数控系统无法用该元素倒圆或倒角。`,
  emptyCentre: (word: string) =>
    `不带坐标的${word}采用最后一点，而前一程序段只给出一个轴：请在该程序段或${word}中编程两个坐标。`,
  sideOnArc: (word: string) => `半径补偿不能从圆弧开始（${word}）：请在之前的直线程序段中编程RL或RR。`,
  toolCallCompensated: (word: string) => `此TOOL CALL处${word}有效：数控系统会拒绝。请先编程R0。`,
};

/** Messages about a running program: spindle, speeds, holes, and the printed rules of the control. */
export const running = {
  spindleStopped: ({ how, block }) => {
    const by = block === undefined ? "" : `（由程序段${block}设定）`;
    return {
      stopped:
        block === undefined
          ? "此处主轴停止：缺少M3、M4、M303或M304。"
          : `此处主轴停止（程序段${block}）。请在此切削之前编程M3、M4、M303或M304。`,
      noSpeed: "此处主轴没有转速：请在此切削之前编程FUNCTION TURNDATA SPIN。",
      hand: `主轴旋转方向${by}不适合此刀具：请编程相反方向。`,
    }[how];
  },
  toolLimit: ({ tool, column, value, limit, x, z }, w) =>
    ({
      DAXN: `刀具${tool}切端面槽 ${w.diameter(value)}；刀板适用于 ${w.diameter(limit)} 以上（DAXN），会与外壁摩擦。`,
      DAXX: `刀具${tool}切端面槽 ${w.diameter(value)}；刀板适用于 ${w.diameter(limit)} 以下（DAXX），会与内壁摩擦。`,
      CDX: `刀具${tool}在${w.place(x, z)}处切入材料 ${w.length(value)}；其最大切深为 ${w.length(limit)}（CDX）。`,
      CUTDIA: `刀具${tool}切断 ${w.diameter(value)}；其适用直径不超过 ${w.diameter(limit)}（CUTDIA）。`,
      DMIN: `刀具${tool}在${w.place(x, z)}处位于 ${w.diameter(value)} 的孔中；它需要 ${w.diameter(limit)}（DMIN）。`,
    })[column],
  holeMissing: ({ tool, diameter, z }, w) =>
    `刀具${tool}以进给移至Z${w.signed(z)}，但该处没有孔：请先钻出至少 ${w.diameter(diameter)} 的孔。`,
  speedUnlimited: ({ diameter, block }, w) =>
    `恒线速度没有SMAX，而程序段${block}达到 ${w.diameter(diameter)}：该处转速不受限制。请编程SMAX。`,
  speedUnlikely: ({ speed, most, of }, w) =>
    of === "material"
      ? `切削速度${w.number(speed)} m/min高于车削的最大值（${w.number(most)} m/min）。`
      : `转速${w.number(speed)} rpm高于机床主轴的最高转速（${w.number(most)} rpm）。`,
  offCentre: ({ y }, w) => `刀具在Y方向偏离中心${w.length(y)}车削：该切削未验证。请编程Y+0并取消Y方向的偏移。`,
  toolIndexUnknown: ({ tool, rows }, w) =>
    `刀具${w.text(tool)}不在刀具表中：${rows.length > 0 ? `该刀具在表中只有${rows.join("、")}` : "表中没有该刀具的行"}。`,
  firstElement: ({ word }, w) => `轮廓不能以${w.text(word)}开始：之前没有已知的点。请以给出X和Z的直线程序段开始。`,
  controlRule: ({ rule, word }, w) => RULES[rule](w.text(word)),
} satisfies Partial<Sentences>;
