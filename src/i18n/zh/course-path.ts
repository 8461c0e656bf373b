import type { CoursePathTexts } from "../en/course-path.ts";

export const coursePath = {
  choose: "学习路线",
  whole: { title: "完整课程", about: "从第一个台阶到完整零件" },
  size: (lessons, exercises, time) => `${lessons} 课 · ${exercises} 个练习 · ${time}`,
  range: (from, to) => `第 ${from} 至 ${to} 课`,
  lessonStates: { new: "未开始", begun: "进行中", done: "已完成" },
  time: (hours, minutes) =>
    `约 ${[hours > 0 && `${hours} 小时`, minutes > 0 && `${minutes} 分钟`].filter(Boolean).join(" ")}`,
  beginTask: (title) => `开始练习：${title}`,
  more: "本课的其他练习",
  review: {
    title: (n) => `复习（${n}）`,
    lead: "借助提示通过的练习，以及答错的问题。",
    step: (questions, exercises, time) =>
      `复习：${[questions > 0 && `${questions} 道题`, exercises > 0 && `${exercises} 个练习`, time].filter(Boolean).join("，")}`,
    question: (lesson, page) => `第 ${lesson} 课第 ${page} 页的问题`,
    repeat: (title) => `重做练习：${title}`,
  },
  made: {
    toReview: (n) => `待复习 ${n} 项`,
    skip: "跳到结尾",
    again: "再播放一次",
    handIn: "提交结果",
  },
} satisfies CoursePathTexts;
