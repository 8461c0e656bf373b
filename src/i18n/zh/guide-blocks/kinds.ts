/** Function of each kind of block, the rule of the control, and common mistakes. */
export const blockKinds = {
  begin: {
    about: "第一个程序段：程序的名称和单位。",
    rule: "名称与文件名相同。",
    mistakes: ["文件改了名，程序段里还是旧名称。"],
  },
  end: {
    about: "最后一个程序段。其后的内容不运行。",
    rule: "名称和单位与 BEGIN PGM 相同。",
    mistakes: ["缺少 M30：结束后主轴和冷却液仍开着。"],
  },
  blankBox: {
    about: "方形毛坯，由最小角点（0.1）和最大角点（0.2）给出。车削时按通过其角点的圆柱计算。",
    rule: "0.1 给出主轴轴线；0.2 在每个轴上取较大的值。",
    mistakes: ["两个角点颠倒：方块没有体积。"],
  },
  blankCylinder: {
    about: "要车削的棒料或圆盘：⌀ 或半径、长度、端面到 Z0 的距离，以及孔。",
    rule: "毛坯只用于仿真。",
    mistakes: ["毛坯比实际的小：机床切削的地方，仿真中没有材料。"],
  },
  blankRotation: {
    about: "锻件或铸件毛坯：绕轴旋转的轮廓。",
    rule: "轮廓在标签之后或在文件中，按其 DIM 计算。",
    mistakes: ["轮廓没有回到轴线：材料的边界未定义。"],
  },
  blankFile: {
    about: "以 STL 文件作毛坯。保留，不仿真。",
    rule: "文件与程序在同一文件夹中；TARGET 选择成品。",
    mistakes: ["文件没有随程序一起导出。"],
  },
  toolDefinition: {
    about: "在程序本身给出刀具长度和半径的旧方式。",
    rule: "刀具在刀具表中时，只写号码的 TOOL DEF 让刀库预先备刀。",
    mistakes: ["用于车刀：车刀需要车刀表。"],
  },
  toolCall: {
    about: "换刀；不写刀具时只改变转速、进给或差值。其后到下一次定位之前，刀尖位置未知。",
    rule: "它结束 FUNCTION TURNDATA CORR 的值和半径补偿。",
    mistakes: ["其后的第一段只有一个轴：另一个轴的位置未定义。"],
  },
  mode: {
    about: "在车削和铣削之间切换。车削时 X 是 ⌀，车削主轴有效。",
    rule: "第一个车削程序段之前写 MODE TURN；机床可能要求运动模型名称。",
    mistakes: ["缺少它：X 按半径计算，车削循环被拒绝。"],
  },
  spin: {
    about: "车削主轴的转速：恒定切削速度加上限，或固定转速。",
    rule: "有效到下一个为止。它不启动主轴：由 M3 或 M4 启动。",
    mistakes: ["它在第一次切削之后。"],
  },
  turnCorrection: {
    about: "在程序中使刀具变长或变短：不改刀具表就修正尺寸。",
    rule: "有效到下一个 TOOL CALL。",
    mistakes: ["符号弄反：DXL 增大，外径变大。"],
  },
  turnBlank: {
    about: "毛坯跟踪：数控系统记录已切除的材料，循环避免空切。",
    rule: "在 BLANK 与 BLANK OFF 之间有效；轮廓必须封闭。",
    mistakes: ["第二次装夹时仍有效：还按旧毛坯计算。"],
  },
  L: {
    about: "直线到一点。未写的轴不动。",
    rule: "进给、补偿和 M 功能继续有效。",
    mistakes: ["缺少负号：Z25 在工件前面。"],
  },
  LP: {
    about: "由到极点 CC 的距离和角度给出的直线。",
    rule: "前面有 CC 程序段。",
    mistakes: ["中间有另一个 CC：点在别处。"],
  },
  C: {
    about: "绕圆心 CC 的圆弧到终点。",
    rule: "起点和终点在绕 CC 的同一个圆上。",
    mistakes: ["终点不在圆上：数控系统报错停止。"],
  },
  CP: { about: "绕 CC 的圆弧到一个角度。", rule: "半径是起点到 CC 的距离。", mistakes: ["缺少 DR：圆弧走反方向。"] },
  CR: {
    about: "由半径给出的到一点的圆弧。",
    rule: "有四条圆弧符合：R 的符号和 DR 选定其中一条。",
    mistakes: ["半径小于弦长的一半：没有这样的圆弧。"],
  },
  CT: {
    about: "与前一元素无拐角相接的圆弧。",
    rule: "两个坐标，并且前面有一个元素。",
    mistakes: ["它跟在一个本应保留的拐角后面。"],
  },
  CTP: {
    about: "到由极点 CC 给出的点的相切圆弧。",
    rule: "这里 CC 不是圆心，而是测量的起点。",
    mistakes: ["把极点当成了圆弧的圆心。"],
  },
  CC: {
    about: "C 和 CP 的圆心，也是所有极坐标程序段的极点。",
    rule: "它不产生移动，有效到下一个 CC。",
    mistakes: ["车削时 X 按半径输入；它是 ⌀。"],
  },
  RND: {
    about: "把前后两段之间的拐角倒圆，没有自己的终点。",
    rule: "它位于平面内两个轨迹程序段之间。",
    mistakes: ["后面的一段太短，放不下该半径。"],
  },
  chamfer: {
    about: "把两条直线之间的拐角两侧各切去同样长度。",
    rule: "它位于两条直线之间。",
    mistakes: ["输入了斜边长度；应为沿边的长度。"],
  },
  free: {
    about: "自由轮廓的一个元素：图纸给多少写多少。保留，不仿真。",
    rule: "数控系统由所有元素一起算出缺少的值。",
    mistakes: ["没有元素给得足够：无解。"],
  },
  undercut: {
    about: "圆柱与端面之间的标准退刀槽。未写的字取自标准。",
    rule: "它在循环的轮廓中，位于两个元素之间。",
    mistakes: ["编写在主程序中：不起作用。"],
  },
  groove: { about: "前面直线中的凹槽。", rule: "它在循环的轮廓中。", mistakes: ["它比所在元素能容纳的宽。"] },
  label: {
    about: "可以调用的位置：子程序、重复、轮廓。LBL 0 结束子程序。",
    rule: "每个号码或名称在程序中只用一次。",
    mistakes: ["子程序在 M30 之前：它会自行再运行一次。"],
  },
  call: {
    about: "运行标签之后的内容，一次或多次。",
    rule: "不带 REP 运行到 LBL 0；带 REP 再运行其前面的部分。",
    mistakes: ["REP 是重复次数：3 表示该部分运行四次。"],
  },
  jump: {
    about: "比较成立时从标签处继续。",
    rule: "两边可以是数字或参数。",
    mistakes: ["循环中没有改变该参数：永不结束。"],
  },
  raise: {
    about: "用此号码的错误停止程序。",
    rule: "对应的文字由机床制造商规定。",
    mistakes: ["它放在每次运行都会经过的地方。"],
  },
  contour: {
    about: "给出下一个循环要车削的轮廓的标签。",
    rule: "依次写多个标签就是一个列表。",
    mistakes: ["缺少该标签，或在另一个文件中。"],
  },
  cycleLine: {
    about: "旧式循环的一行。第一行是 .0。",
    rule: "一个循环的各行相连。",
    mistakes: ["中间删了一行：循环把下一行当作它。"],
  },
  cycle: {
    about: "保留但不仿真的循环：其值不变。",
    rule: "在调用处或所在处起作用。",
    mistakes: ["其作用被当作已验证：从此处起程序未验证。"],
  },
  cycleCall: {
    about: "从刀具所在处运行最后定义的循环。",
    rule: "定位程序段中的 M99 作用相同；M89 在每段都调用，直到 M99。",
    mistakes: ["调用时刀具在材料中。"],
  },
  selectContour: {
    about: "从文件取下一个循环的轮廓。",
    rule: "文件与程序在同一文件夹中。",
    mistakes: ["文件名缺少扩展名。"],
  },
  contourDefinition: {
    about: "在一个程序段中给出轮廓的区域、岛和空腔。",
    rule: "P 是区域，I 是岛，V 是空腔。",
    mistakes: ["岛写在它所在的区域之前。"],
  },
  declareContour: { about: "为轮廓公式给轮廓命名。", rule: "原样保留，不仿真。", mistakes: ["名称用了两次。"] },
  contourFormula: {
    about: "连接已声明的轮廓：并、交、差。",
    rule: "原样保留，不仿真。",
    mistakes: ["缺少括号：运算从左算起。"],
  },
  callProgram: {
    about: "在此处运行另一个程序。",
    rule: "它的 END PGM 之后本程序继续。",
    mistakes: ["被调程序中的 M30 结束一切。"],
  },
  selectProgram: {
    about: "给出 CALL SELECTED PGM 要运行的程序。",
    rule: "名称可以放在 QS 参数中。",
    mistakes: ["中间又选了别的：以它为准。"],
  },
  callSelected: { about: "运行最后选定的程序。", rule: "前面有 SEL PGM。", mistakes: ["什么都没有选。"] },
  datum: {
    about: "移动原点：其后的坐标以新原点为基准。",
    rule: "有效到下一个；RESET 取消。",
    mistakes: ["在程序后半部分仍然有效。"],
  },
  datumTable: {
    about: "按原点表中的一行移动原点。该表在此未知。",
    rule: "必须已选定该表。",
    mistakes: ["机床上激活的是另一张表。"],
  },
  mirror: { about: "镜像铣削程序段的坐标。", rule: "RESET 或不写轴即结束。", mistakes: ["顺铣变成逆铣。"] },
  rotation: { about: "绕原点旋转铣削程序段的平面。", rule: "RESET 结束。", mistakes: ["极点也一起旋转。"] },
  scale: { about: "放大或缩小铣削坐标。", rule: "RESET 结束。", mistakes: ["输入了百分数：99 会放大 99 倍。"] },
  plane: {
    about: "倾斜加工面，或将其复位。倾斜加工不仿真。",
    rule: "MOVE、TURN 或 STAY 说明各轴如何动作。",
    mistakes: ["车削前没有复位。"],
  },
  assign: {
    about: "给 Q 参数赋值或计算。",
    rule: "Q 在所有程序中有效，QL 只在本程序中，QR 断电后仍保留。",
    mistakes: ["循环自己要用该参数。"],
  },
  assignText: { about: "把文本放入 QS 参数。", rule: "各部分用 || 连接。", mistakes: ["缺少引号。"] },
  functions: {
    about: "不带移动的 M 功能：主轴、冷却液、进给单位。",
    rule: "有的在本段移动之前起作用，有的在之后。",
    mistakes: ["第一个每转进给之前缺少 M136。"],
  },
  stop: {
    about: "停止，直到按 NC 启动。",
    rule: "若无 M 功能另行规定，主轴和冷却液保持开启。",
    mistakes: ["它在切削中：切削刃在一处摩擦。"],
  },
  comment: { about: "供阅读程序的文字。", rule: "不影响加工。", mistakes: ["注释中的值后来已改变。"] },
  structure: {
    about: "程序结构中的标题（结构项）。",
    rule: "数控系统的结构视图显示它。",
    mistakes: ["移动了各部分，标题却留在原处。"],
  },
};
