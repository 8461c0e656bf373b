/* What the first screen shows of this feature. */

export { startOfflineLater } from "./start-offline.ts";
