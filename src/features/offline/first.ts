/* The part of this feature that the first screen needs. */

export { scheduleOfflineStart as startOfflineLater } from "./start-offline.ts";
