/* The part of this feature that the first screen needs. */

export { startOfflineLater } from "./start-offline.ts";
