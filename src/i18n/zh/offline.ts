import type { OfflineTexts } from "../en/offline.ts";

export const offline = {
  install: {
    install: "安装",
    why: "安装后，Turnwise 有独立窗口，并在本设备上显示图标。",
    byHand: "安装方法：点“共享”，再点“添加到主屏幕”。",
  },
  ready: "Turnwise 有新版本可用。",
  updateNow: "立即更新",
  later: "稍后",
  elsewhere: "Turnwise 已在另一个标签页中更新。本标签页保持原来的版本。",
  reload: "重新加载页面",
  look: "检查更新",
  kept: {
    impossible: "此浏览器不能保存页面以供离线使用；需要 https 地址。",
    coming: "正在将页面保存到本设备以供离线使用…",
    kept: "已保存在本设备上：无网络也可使用。",
    failed: "页面尚未完整保存到本设备，联网后继续下载。",
  },
  looked: {
    no: "",
    looking: "正在检查更新…",
    coming: "正在下载新版本…",
    newest: "当前已是最新版本。",
    unreachable: "服务器没有响应。此版本可继续使用。",
    unfinished: "新版本未能完整下载，继续使用当前版本。",
  },
} satisfies OfflineTexts;
