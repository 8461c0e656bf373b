/* The page without a network, and its newer versions. */

export { startOfflineLater } from "./start-offline.ts";
export const fetchOfflineState = () => import("./OfflineState.tsx");
export const fetchUpdateBar = () => import("./UpdateBar.tsx");
