import type { MessagesTexts } from "../../message-texts.ts";
import { running } from "./messages/running.ts";
import { threads } from "./messages/threads.ts";

/** The value that a finding proposes, if any. */
const nearest = (value: number | undefined, say: (value: number) => string) =>
  value === undefined ? "" : `建议：${say(value)}。`;

const reasons: MessagesTexts["reasons"] = {
  insertRadius: "刀尖半径",
  mainEdge: "主切削刃",
  secondaryEdge: "副切削刃",
  toolWidth: "刀具宽度",
  cutLength: "CUTLENGTH",
  limit: "加工极限",
  plunging: "不允许切入",
  oversize: "余量",
  smoothing: "各刀之间的台阶",
  correction: "刀具补偿",
  overCrest: "螺纹牙顶以上的材料",
  behindContour: "轮廓背后的凹槽，该循环切不到；F 型请插入工序“按标准的退刀槽”",
};

const ELEMENT = { angle: "角度", length: "长度", radius: "半径" };

/** Clamping devices. */
const CLAMPED = {
  jaws: "卡爪",
  chuck: "卡盘",
  collet: "弹簧夹头",
  driver: "拨盘",
  tailstock: "尾座",
  limit: "夹持极限",
};

/** Units of a feed. */
const FEED = { "mm/min": "mm/min", "mm/rev": "mm/转" };

export const messages = {
  reasons,
  morePlaces: (place, more) => `${place}（另有${more}处同类）`,
  of: {
    ...running,
    ...threads,
    missing: () => "请输入数值。",
    notANumber: (d, w) => `“${w.text(d.text)}”不是数字。`,
    badExpression: (d, w) => `“${w.text(d.text)}”无法计算。`,
    unknownParameter: (d) => `${d.name}在此处没有值，请输入数字。`,
    outOfRange: (d, w) =>
      `${w.value(d.value)}超出范围${w.value(d.min)}至${w.value(d.max)}。${nearest(d.nearest, w.value)}`,
    notWhole: (d, w) => `${w.number(d.value)}不是整数。${nearest(d.nearest, w.number)}`,
    notAChoice: (d, w) => `${w.number(d.value)}不在可选值${d.choices.join("、")}中。${nearest(d.nearest, w.number)}`,
    startEqualsEnd: (d, w) => `起点与终点相同：${d.other}也是${w.value(d.value)}。`,
    startLevelWithEnd: (d, w) => `起点位于${d.axis} ${w.size(d.value)}，与轮廓终点相同：两者之间没有可加工的材料。`,
    diameterNegative: (d, w) => `${w.value(d.value)}：该直径位于旋转轴线的另一侧。${nearest(d.nearest, w.value)}`,
    elementTooLong: (d, w) => `${w.size(d.size)}大于该元素的长度，最大${w.size(d.max)}。`,
    cornersTooWide: (d, w) => `两个半径${w.size(d.radius)}的圆角宽于槽底，最大${w.size(d.max)}。`,
    wallsMeet: (d, w) => `角度为${w.angle(d.angle)}时两侧壁在槽底上方相交，须小于${w.angle(d.max)}。`,
    cornerSmallerThanInsert: (d, w) =>
      `角半径${w.size(d.radius)}小于刀尖半径${w.size(d.insert)}：该角保留${w.size(d.insert)}。`,
    recessNarrowerThanTool: (d, w) =>
      `槽底宽${w.size(d.width)}，刀具和余量需要${w.size(d.tool)}。${nearest(d.nearest, w.value)}`,
    angleNotFollowed: (d, w) =>
      `${d.element === undefined ? "" : `元素${d.element}：`}刀具无法跟随${w.angle(d.angle)}：${
        d.edge === "behindContour"
          ? "该角度通向轮廓背后，本循环用任何刀具都切不到"
          : `${reasons[d.edge]}允许${w.angle(d.max)}`
      }，有残余材料。`,
    tooManyPasses: (d, w) => `${d.passes} 次走刀超过 ${d.most} 次。${nearest(d.nearest, w.size)}`,
    infeedOverCutLength: (d, w) =>
      `进刀量${w.size(d.infeed)}大于CUTLENGTH ${w.size(d.cutLength)}：自动减小为${w.size(d.cutLength)}。`,
    depthOverCutLength: (d, w) => `深度${w.size(d.depth)}大于CUTLENGTH ${w.size(d.cutLength)}：有残余材料。`,
    offsetReduced: (d, w) => `偏移${w.size(d.offset)}减小为${w.size(d.kept)}：${d.passes}刀共用有效宽度的80%。`,
    offsetOverLimit: (d, w) =>
      `${d.passes}刀的侧向偏移共${w.size(d.offset)}；有效宽度的80%为${w.size(d.max)}。${nearest(d.nearest, w.size)}`,
    toolUnfit: (d) =>
      `${d.type} 刀具、刀尖方向 ${d.orientation} 不适用。适用：${d.types.join(" 或 ")}，刀尖方向 ${d.orientations.join("、")}。`,
    toolCannotCutSideways: (d) => `${d.type}刀具只能切入，本循环还需横向切削。请使用RECTURN刀具。`,
    flanksNotChecked: () => "T-ANGLE或P-ANGLE为空：不检查刀片侧刃。",
    toolColumn: (d, w) => {
      const what =
        d.value === null
          ? d.column === "TYPE"
            ? "TYPE缺失或不是刀具类型。"
            : `${d.column}缺失或不是数字。`
          : `${d.column} ${w.value(d.value)}不可用。`;
      if (d.min !== undefined && d.max !== undefined) return `${what}允许范围：${w.value(d.min)}至${w.value(d.max)}。`;
      if (d.min !== undefined) return `${what}必须${d.column === "CUTWIDTH" ? "大于" : "不小于"}${w.value(d.min)}。`;
      return d.max === undefined ? what : `${what}必须小于${w.value(d.max)}。`;
    },
    toolNumberTwice: (d) => `刀具${d.number}已在刀具表中。${nearest(d.nearest, String)}`,
    toolName: (d, w) => `“${w.text(d.text)}”：名称最多${d.max}个字符，仅限大写字母、数字和# $ % & , - . _符号。`,
    holderAxis: (d, w) => `“${w.text(d.text)}”：刀杆只能沿X或Z方向。`,
    holderHead: (d, w) =>
      `“${w.text(d.text)}”不是轮廓。每个角点写作Z/X（从刀尖起），角点间用空格，各部分间用分号；每部分至少三个角点。`,
    bladeSupport: (d, w) => `“${w.text(d.text)}”不是刀板支撑：NONE、STRAIGHT 或 CURVED。`,
    straightBlade: () => "直刀板切端面槽时会摩擦：需要适合该直径（DAXN、DAXX）的弧形刀板。",
    pointDiffers: (d, w) =>
      `钻尖长度${w.size(d.length)}与顶角${w.angle(d.angle)}（应为${w.size(d.byAngle)}）不符：以角度为准。`,
    betterTool: (d) => `刀具${d.tool} ${d.name}适用于该轮廓。`,
    startInArea: (d, w) => `起点${w.place(d.x, d.z)}在加工区内：刀具先移至安全高度。`,
    startInMaterial: (d, w) => `起点${w.place(d.x, d.z)}在材料中。`,
    startBelowContour: (d, w) => `起点比轮廓起点低 ${w.length(d.below)}：刀具先移到轮廓起点的高度。`,
    startBehindContour: (d, w) =>
      `起点位于轮廓起点之后 ${w.length(d.behind)}：刀具先沿Z轴移到轮廓起点前安全高度 ${w.size(d.clearance)} 处。`,
    startInPart: (d, w) => `起点位于成品工件内：从该处不会切削。有效起点：${w.place(d.x, d.z)}。`,
    insertAcrossAxis: (d, w) =>
      `刀片越过轴线 ${w.length(d.reach)}，在该处损伤轮廓。` +
      (d.nearest === undefined ? "刀片对该孔过长。" : `起点从 X${w.diameter(d.nearest)} 起即可避开。`),
    boreMissing: (d, w) =>
      `缺少底孔：从Z${w.signed(d.z)}起为实心材料，而循环要加工到Z${w.signed(d.to)}。请先钻出至少 ${w.diameter(d.need)} 的孔直到该处。`,
    startOnWrongSide: (d, w) => `轮廓朝起点方向走：从这一侧不会切削。有效起点：${w.place(d.x, d.z)}。`,
    startInsideEnvelope: (d, w) => `起点距轮廓小于安全高度${w.size(d.clearance)}：刀具以精加工进给直接移至轮廓。`,
    limitOnWrongSide: (d, w) =>
      `极限为${w.value(d.limit)}时，刀具所在一侧没有可加工的材料。${nearest(d.nearest, w.value)}`,
    cutBehindLimit: (d, w) =>
      `极限之外，${w.place(d.x, d.z)}处切除${w.area(d.area)}材料：极限只适用于轮廓，不适用于接近和离开。` +
      (d.finishing ? "仅粗加工（Q215 = 1）时该处不切削。" : "请设置极限，使接近和离开不碰到材料。"),
    nothingToCut: () => "起点与轮廓之间没有可加工的材料。",
    contourMissing: (d, w) => (d.label === "" ? "缺少轮廓。" : `轮廓LBL ${w.text(d.label)}不存在。`),
    contourTooShort: () => "轮廓至少需要两个不同的点。",
    contourFlat: (d) => `轮廓的起点与终点${d.axis}相同：两者之间没有可加工的材料。`,
    contourEndCovered: (d, w) => `轮廓终点${w.place(d.x, d.z)}位于轮廓自身之内：有元素超出该终点，工件无法延续。`,
    contourPoint: (d) => `元素${d.element}：终点缺失或无法到达。`,
    cornerElementAlone: (d) => `元素${d.element}：倒角或倒圆前后都需要有元素，倒角需要两条直线。`,
    cornerElementTooLong: (d, w) => `元素${d.element}：${w.size(d.size)}在相邻元素之间放不下，最大${w.size(d.max)}。`,
    arcOffCircle: (d, w) => `元素${d.element}：终点偏离圆${w.size(d.gap)}。`,
    arcTooSmall: (d, w) => `元素${d.element}：半径${w.size(d.radius)}对该终点过小。`,
    elementFree: (d) => `元素${d.element}：还需要${d.freedom}个数值。`,
    elementContradicts: (d, w) =>
      d.quantity === "tangent"
        ? `元素${d.element}与前一元素不相切，偏差${w.number(d.nearest)}°。`
        : `元素${d.element}：${ELEMENT[d.quantity]}${(d.quantity === "angle" ? w.number : w.size)(d.given)}与其他数值矛盾，${(d.quantity ===
            "angle"
            ? w.number
            : w.size)(d.nearest)}可用。`,
    elementUnreachable: (d) => `元素${d.element}：按此长度、半径或角度无法到达相邻元素。`,
    centreMissing: (d) => `元素${d.element}：缺少圆心，请在其前面加入CC。`,
    contourCrossesItself: (d) => `元素${d.element}与元素${d.other}相交。`,
    toolRadiusTooLarge: (d, w) =>
      `第 ${d.element} 个元素：刀具半径 ${w.size(d.radius)} 过大。${nearest(d.nearest, w.size)}`,
    pathCutsContour: (d, w) =>
      `沿第 ${d.element} 个元素加工时，刀具在 ${w.spot(d.x, d.y, undefined)} 切入第 ${d.other} 个元素 ${w.length(d.depth)}：刀具过大；数控系统只检查相邻元素。${nearest(d.nearest, w.size)}`,
    approachNeedsSide: () => "CT 需要 RL 或 RR：编程R0时数控系统在此停止。",
    approachSideAssumed: () => "R0未指定侧面：假定从轮廓左侧接近。未验证。",
    approachInsideCircle: (d, w) =>
      `${d.point} 位于 R ${w.size(d.radius)} 的圆内：从该点无法作切线。${nearest(d.nearest, w.size)}`,
    approachCutsContour: (d, w) =>
      `在 ${d.point} 与轮廓之间，刀具在 ${w.spot(d.x, d.y, d.z)} 切入轮廓 ${w.length(d.depth)}；数控系统不检查此处。可用的 ${d.point}：` +
      `${w.spot(d.freeX, d.freeY, d.freeZ)}。`,
    approachValueCutsContour: (d, w) =>
      `在 ${d.point} 与轮廓之间，刀具在 ${w.spot(d.x, d.y, d.z)} 切入轮廓 ${w.length(d.depth)}；数控系统不检查此处。可用值：${d.word} ` +
      `${w.size(d.nearest)}。`,
    approachBlocked: (d, w) =>
      `在 ${d.point} 与轮廓之间，刀具在 ${w.spot(d.x, d.y, d.z)} 切入轮廓 ${w.length(d.depth)}；数控系统不检查此处。`,
    undercutNeighbours: (d) => `元素${d.element}：退刀槽需要相接的圆柱面和端面，凹槽需要与其方向一致的直线元素。`,
    recessWord: (d) => `元素${d.element}：${d.word}缺失，或不构成有效形状。`,
    recessWordsExclusive: (d) => `元素${d.element}：${d.other}与${d.word}只能输入其中一个。`,
    pitchNotListed: (d, w) => {
      const near = [d.below, d.above].flatMap((n) => (n === undefined ? [] : [w.size(n, 4)])).join("和");
      return `元素${d.element}：DIN 76没有螺距${w.size(d.pitch, 4)}的退刀槽，最接近的螺距：${near}。请使用其中之一，或输入${d.words}。`;
    },
    undercutDefaults: (d) => `元素${d.element}：${d.words}取自标准，对本数控系统未验证；请输入以确保正确。`,
    materialLeft: (d, w) =>
      d.asked === undefined
        ? `${w.place(d.x, d.z)}处残余材料${w.area(d.area)}，原因：${reasons[d.reason]}。`
        : d.reason === "oversize"
          ? `${w.place(d.x, d.z)}处余量${w.area(d.area)}，与编程一致。`
          : `${w.place(d.x, d.z)}处的角为刀尖半径：残余材料${w.area(d.area)}。未编程其他半径。`,
    gouge: (d, w) => `${w.place(d.x, d.z)}处轮廓损伤：${w.area(d.area)}。`,
    rapidInStock: (d, w) => `快移在${w.place(d.x, d.z)}处穿过${w.area(d.area)}材料。`,
    holderContact: (d, w) => `刀杆在${w.place(d.x, d.z)}处碰到材料。`,
    cutBelowContour: (d, w) =>
      `此切削在${w.place(d.x, d.z)}处低于程序段${d.block}中循环的轮廓${w.area(d.area)}。如果是有意的，请确认。`,
    intendedCut: (d, w) =>
      `程序段${d.blocks.join("、")}中低于轮廓的切削已标记为有意：${w.place(d.x, d.z)}处${w.area(d.area)}。`,
    cameLoose: (d, w) =>
      `${w.place(d.x, d.z)}处的${{ piece: "一段工件", ring: "一个环", slug: "一个料芯" }[d.shape]}（${w.area(
        d.area,
      )}）不再与夹持端相连：程序段${d.block}将其切下。`,
    partedOff: (d, w) => `${w.place(d.x, d.z)}处的工件（${w.area(d.area)}）在程序段${d.block}切断，并从仿真中移除。`,
    cutOnLoosePiece: (d, w) =>
      `程序段${d.block}在加工完成前已将该段切下：${w.place(d.x, d.z)}处将在未夹持的工件上切削${w.area(d.area)}。请最后切断。`,
    behindBlank: (d, w) =>
      d.motion === "unheld"
        ? `外圆一直车到毛坯后端Z${w.size(d.rear)}：没有剩余的夹持面。如果以其他方式夹持，请定义装夹。`
        : `${d.motion === "rapid" ? "快移" : "刀具切削"}进入毛坯后端Z${w.size(d.rear)}之后，位于${w.place(d.x, d.z)}：那里是夹具。`,
    clampContact: (d, w) =>
      `${d.by === "tool" ? "刀具" : "刀杆"}在${w.place(d.x, d.z)}处与${CLAMPED[d.part]}碰撞。请提前结束切削或更改装夹。`,
    contactsUnlooked: (d) => `已有${d.limit}个运动损伤轮廓、快移进入材料或刀杆碰到材料：从此处起不再检查。`,
    deeperThanInfeed: (d, w) =>
      "" +
      (d.pass === undefined ? "一次平滑或精加工" : `第${w.number(d.pass)}刀`) +
      `切深${w.length(d.depth)}，最大允许${w.length(d.allowed)}。`,
    blankLacks: (d, w) => `${w.text(d.what)} 的轮廓缺少程序中存在的${w.area(d.area)}材料。以该轮廓为准。`,
    blankGone: (d, w) => `${w.text(d.what)} 的轮廓中有${w.area(d.area)}已切除。已切除的材料不会恢复。`,
    nothingCut: () => "此次加工没有切除材料。",
    airPasses: (d) => `${d.count}次空走刀。`,

    notUnderstood: (d, w) => `无法识别“${w.text(d.text)}”：保留，不仿真。`,
    wordNotUnderstood: (d, w) => `无法识别“${w.text(d.text)}”。`,
    wordTwice: (d, w) => `${w.text(d.word)}在该程序段中出现两次，以最后一个为准。`,
    equalsMissing: (d, w) => `“${w.text(d.text)}”缺少等号，按有等号读取。`,
    blankBeforeEquals: (d, w) => `“${w.text(d.text)}”的等号前有空格。`,
    lineTooLong: (d) => `该行超过${d.most}个字符：文本保留，但不读取。`,
    badNumber: (d, w) => `“${w.text(d.text)}”不是数字。`,
    wordMissing: (d, w) => `该程序段缺少${w.text(d.word)}。`,
    blockNumber: (d) => `程序段号${d.found}不连续，应为${d.expected}。`,
    blockNumberMissing: (d) => `该程序段没有编号，应为${d.expected}。`,
    listWithoutTilde: (d) => `${d.places}个循环参数列表的行末缺少~：数控系统无法加载该程序。`,
    continuationOpen: () => "该行以~结尾，但没有续行。",
    isoProgram: () => "该文本为 DIN/ISO 格式。请作为单独的程序打开，届时会转换为 Klartext。",
    frameMissing: (d) => `程序缺少${d.which}。`,

    notSimulated: (d, w) => `${w.text(d.what)}：保留，不仿真。`,
    notProved: (d, w) => `${w.text(d.what)} 未仿真，可能改变路径或毛坯：从此处起未验证。`,
    cycleNotSimulated: (d, w) => `循环${d.cycle} ${w.text(d.name)}：保留，不仿真。`,
    noCycleDefined: () => "调用前没有定义循环。",
    noToolCalled: () => "该程序段之前没有调用刀具。",
    toolUnknown: (d, w) => `刀具${w.text(d.tool)}不在刀具表中。`,
    notInTurnMode: () => "该循环只能在FUNCTION MODE TURN下执行：请在调用前编写该程序段。",
    compensationActive: (d) => `此处${d.side}仍有效，而数控系统要求R0：请在之前的定位程序段中编写R0。`,
    feedZero: (d, w) => `${w.text(d.word)}：此处切削进给为0。请给出大于0的进给；FAUTO采用TOOL CALL中的F。`,
    feedUnlikely: (d, w) => `${w.feed(d.feed, FEED[d.unit])}的进给不合理。请检查M136：编程M136时F为每转进给。`,
    pointBeyondDepth: (d, w) => `孔深${w.size(d.depth)}，而钻尖长${w.size(d.point)}：孔达不到其直径。`,
    drillTooShort: (d, w) =>
      `孔深${w.size(d.depth)}，而钻头切削刃长度（LCUTS）为${w.size(d.edges)}：钻柄可能摩擦孔壁。`,
    centreMouth: (d, w) =>
      `中心孔在端面处为⌀${w.size(d.mouth)}，应为⌀${w.size(d.wanted)}：其钻头需要深度${w.size(d.depth)}。`,
    pitchOfTap: (d, w) => `Q239为${w.size(d.pitch)}，而刀具表中丝锥的PITCH为${w.size(d.tap)}。`,
    freeChosen: () => "从这里起有多个轮廓符合所给数据：显示最短的轮廓。数控系统采用FSELECT选择的轮廓。",
    freeUnsolved: (d, w) => `${w.text(d.form)}：所给数据不能确定该元素，或相互矛盾。请给出更多数据，或使用FSELECT。`,
    cycleNeverCalled: (d) => `循环${d.cycle}已定义但从未调用：其后缺少CYCL CALL或M99。`,
    neverReached: (d) => `程序在此程序段之前以${d.by}结束：该程序段从不执行。`,
    listOfOlderSoftware: (d, w) =>
      `循环${d.cycle}的参数列表来自旧版软件，数控系统补充：${d.filled.map((word) => w.text(word)).join("，")}。`,
    parameterForeign: (d, w) => `${w.text(d.name)}在此处不允许：循环${d.cycle}没有该参数，或该参数编程两次。`,
    runsIntoLabel: (d, w) => `程序继续运行进入了LBL ${w.text(d.label)}的轮廓：其前缺少M30。`,
    contourStartIncomplete: (d) => `轮廓的第一个程序段需要X和Z；缺少${d.axis}。`,
    approachUncompensated: (d) => `${d.form}没有RL或RR：其后的轮廓在没有半径补偿的情况下运行。`,
    labelMissing: (d, w) => `LBL ${w.text(d.label)}不存在。`,
    labelTwice: (d, w) => `LBL ${w.text(d.label)}在程序中出现两次。`,
    labelNotClosed: (d, w) => `LBL ${w.text(d.label)}没有用LBL 0结束。`,
    contourNotNamed: (d) => `循环${d.cycle}调用前需要循环14及其轮廓。`,
    contoursJoined: (d, w) =>
      `${w.text(d.joined)}：此处组合了多个轮廓。循环${w.number(d.cycle)}只加工一个轮廓，其路径不显示。`,
    errorRaised: (d, w) =>
      d.error === null
        ? "FN 14：数控系统在此报错停止，其后的程序段不执行。"
        : `FN 14：数控系统在此报错停止（错误号${w.number(d.error)}），其后的程序段不执行。`,
    contourInFile: (d, w) => `轮廓在文件${w.text(d.file)}中，该文件不可用：请将轮廓写入标签并用循环14选择。`,
    feedMissing: () => "没有编程进给速率。",
    spindleMissing: () => "没有编程主轴转速，无法计算时间。",
    parameterUnset: (d) => `${d.name}在此处没有值。`,
    divisionByZero: () => "除数为零。",
    notFinite: (d, w) => `“${w.text(d.text)}”得不到可用的数值。`,
    clampingUnread: (d, w) => `CLAMPING：无法识别“${w.text(d.what)}”，予以忽略。`,
    clampingIncomplete: (d) => `CLAMPING被忽略：缺少${d.words}或数值无效。装夹未知。`,
    clampingTwice: () => "CLAMPING定义了两次：以第一个为准。请删除此处。",
    clampingMisses: (d, w) =>
      `装夹没有夹住毛坯：夹持范围内没有${w.diameter(d.diameter)}的表面。请检查CLAMPING的直径、长度和端面。`,
    blankMissing: () => "程序没有定义毛坯。",
    blankNotTurned: (d, w) => `${w.text(d.form)}形式的毛坯不是绕轴的回转体。`,
    endsExchanged: (d, w) =>
      d.axis === "X"
        ? `从X${w.diameter(d.start)}到X${w.diameter(d.end)}没有可切削的材料。起点与终点（${d.other}）是否颠倒？`
        : `从Z${w.signed(d.start)}到Z${w.signed(d.end)}循环背离卡盘切削。起点与终点（${d.other}）是否颠倒？`,
    endInFront: (d, w) => `Z${w.signed(d.value)} 在工件前方。是否为 ${w.signed(d.nearest)}？`,
    startInFront: (d, w) => `Z${w.signed(d.value)} 在工件前方。是否为 ${w.signed(d.nearest)}？`,
    diameterInSolid: (d, w) => `${w.diameter(d.value)} 位于实心毛坯内部：没有可供刀具开始加工的孔。`,
    diameterOutside: (d, w) => `${w.diameter(d.value)} 大于毛坯 ${w.diameter(d.blank)}。`,
    blankAgainstContour: (d, w) =>
      ({
        outside: `轮廓达到 ${w.diameter(d.contour)}，毛坯只有 ${w.diameter(d.blank)}。建议：${w.diameter(d.nearest)}。`,
        bore: `毛坯内孔为 ${w.diameter(d.blank)}，轮廓止于 ${w.diameter(d.contour)}：没有切削。建议：${w.diameter(d.nearest)}。`,
        length: `轮廓达到 Z${w.signed(d.contour)}，毛坯只到 Z${w.signed(d.blank)}。建议：${w.size(d.nearest)}。`,
        allowance: `轮廓从 Z${w.signed(d.contour)} 开始，毛坯从 Z${w.signed(d.blank)} 开始：空切。建议：${w.signed(d.nearest)}。`,
        thread: `螺纹为 ${w.diameter(d.contour)}，毛坯为 ${w.diameter(d.blank)}。建议：${w.diameter(d.nearest)}。`,
      })[d.place],
    blankImpossible: () => "毛坯没有体积：请检查其尺寸。",
    boxTurned: (d, w) =>
      `方料按外接其各角的圆柱处理，直径 ${w.size(d.outer)}。只有直径 ${w.size(d.inner)} 以内整圈一定有材料。圆棒料请用 BLK FORM CYLINDER。`,
    blankTaken: (d, w) => `${w.text(d.what)} 用作毛坯。`,
    blankAdds: (d, w) => `${w.text(d.what)} 的轮廓比 BLK FORM 多出${w.area(d.area)}。以该轮廓为准。`,
    blankTraced: () => "毛坯跟踪期间，粗加工省略不接触材料的层。数控系统可能缩短的其他空行程仍完整显示。",
    poleMissing: () => "该程序段之前需要极点CC。",
    startUnknown: () => "该程序段之前的位置未知。",
    arcImpossible: () => "这些数值无法构成圆弧。",
    radiusCompensation: (d) => `已读取${d.side}，但不补偿路径。`,
    compensationUndefined: (d) =>
      `${d.side} 与刀尖方向 TO ${d.orientation}：补偿方向不明确。请使用刀尖指向角落方向的刀具，或以 R0 编程该路径。`,
    sideChanged: () => "RL 与 RR 之间需要一个 R0 程序段。",
    approachWithoutContour: (d) => `${d.form} 需要相邻的轮廓元素。`,
    lengthDelta: (d) => `刀具${d.tool}的DZL和DXL：数控系统已将其计入刀具长度。刀尖仍在路径上，路径和毛坯均不变。`,
    toolRadiusUnknown: (d, w) => `刀具 ${w.text(d.tool)} 的半径未知：路径按半径 0 计算。`,
    wordsRecalled: (d, w) => `${w.text(d.what)}：其参数未与手册核对；请在数控系统上核实。`,
    programEndMissing: () => "主程序末尾缺少M30或M2。",
    tooManyBlocks: (d) => `已执行超过${d.limit}个程序段：在该处停止。`,
    tooManyRepeated: (d) => `重复执行超过${d.limit}个程序段：在该处停止。某个跳转或重复可能没有结束。`,
    tooManyMoves: (d) => `超过${d.limit}个运动：在该处停止。`,
    contourTooLong: (d) => `轮廓超过${d.limit}个程序段：在该处停止。`,
    tooManyOperations: (d) => `超过${d.limit}次循环调用：在该处停止。`,
    moreAlike: (d, w) => `从此处起另有 ${w.number(d.count)} 条同类检查信息（${d.code}）只计数，不再列出。`,
    callsTooDeep: (d) => `标签嵌套调用超过${d.limit}层。`,
    programsTooDeep: (d) => `程序嵌套调用超过${d.limit}层：其中一个无休止地调用自身。在该处停止。`,
    endInCalled: (d) => `${d.word}位于被调用的程序中，数控系统不允许：调用程序从调用之后继续。`,
    programNotOpened: (d, w) => `${w.text(d.file)}未打开：请与本程序一起打开以执行。`,
    programNotSelected: () => "CALL SELECTED PGM需要先用SEL PGM选择程序。",
  },
} satisfies MessagesTexts;
