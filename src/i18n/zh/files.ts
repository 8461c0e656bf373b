import type { FilesTexts } from "../en/files.ts";

export const files: FilesTexts = {
  changed: { title: (file) => `设备上的 ${file} 已改变`, text: "文件内容与此处读取或保存的不同，尚未写入任何内容。" },
  gone: { title: (file) => `${file} 已不在原处`, text: "文件被移动、改名或删除，尚未写入任何内容。" },
  refused: { title: (file) => `不允许写入 ${file}`, text: "浏览器未获得写入权限。" },
  failed: { title: (file) => `无法写入 ${file}`, text: "设备拒绝了该文件，程序仍在此处打开。" },
  compare: "比较",
  overwrite: "覆盖",
  elsewhere: "另存为其他文件",
  download: "下载",
  cancel: "取消",
  choose: {
    title: "打开哪个程序？",
    lead: (programs) => `有 ${programs} 个程序未被其他程序调用。每个程序连同它调用的文件各自打开。`,
    open: (file) => `打开 ${file}`,
    with: (count) => `含 ${count} 个文件`,
    alone: "不调用其他文件",
    all: (count) => `全部打开（${count} 个）`,
    together: "全部作为一个程序打开",
    skipped: (count) => `${count} 个文件不是程序文本，已略过。`,
    cut: "文件夹内容超过一次可打开的数量，其余已略过。",
  },
};
