import type { StartTexts } from "../../en/first/start.ts";

export const start = {
  hint: "在本页任意处键入即可搜索，例如 812。支持四种语言。",
  doors: {
    title: "开始方式",
    guide: "帮助",
    glossary: "术语表",
    program: "编程一个循环",
    programHow: "像在数控系统上一样回答提问；车床画面显示每个数值",
    openHow: "Klartext 或 DIN/ISO：检查、用对话修改、导出",
    plan: "由零件生成加工方案",
  },
  hero: {
    name: (n) => `一根轴分 ${n} 道工序车削：刀具运动，材料被切除`,
    play: "播放",
    pause: "暂停",
    finish: "精加工",
    position: "定位",
    proved: "已验证",
    open: "打开此程序",
    pass: (n, of) => `第 ${n} 刀，共 ${of} 刀`,
    facts: (operations, tools) => `${operations} 道工序 · ${tools} 把刀具`,
  },
  beyond: "超越数控系统",
  beyondAll: {
    values: { what: "三个数值并列", how: "同一参数的小值、常用值和大值，全部仿真" },
    steps: { what: "逐步播放", how: "单独播放循环的每一步" },
    advice: { what: "切削参数与建议", how: "按材料、刀具和刀片给出起始值" },
    which: { what: "查找循环", how: "给出形状：每种方案都仿真并比较" },
    code: { what: "由 ISO 代码生成刀具", how: "一行代码如 CNMG 120408 即填好刀具" },
    contour: { what: "含未知尺寸的轮廓", how: "缺少的尺寸由其他尺寸算出" },
    approach: { what: "APPR 和 DEP", how: "全部八种功能，用于您的轮廓" },
    compare: { what: "比较程序", how: "按加工效果比较，并给出改动所需的时间" },
    drawing: { what: "车间图", how: "任何程序的带尺寸图纸，可打印" },
    share: { what: "用二维码分享", how: "程序、刀具和检查结果在一个链接中" },
    verify: { what: "命令行检查", how: "node verify.mjs PROGRAM.H，无需浏览器" },
  },
} satisfies StartTexts;
