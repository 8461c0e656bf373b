/* Offline support, and updates. */

export const fetchOfflineState = () => import("./OfflineState.tsx");
export const fetchUpdateBar = () => import("./UpdateBar.tsx");
