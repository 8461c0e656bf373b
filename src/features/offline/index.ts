/* The page without a network, and its newer versions. */

export const fetchOfflineState = () => import("./OfflineState.tsx");
export const fetchUpdateBar = () => import("./UpdateBar.tsx");
