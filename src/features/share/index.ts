/* Sharing of works, both ways. */

export const fetchQrSection = () => import("./QrSection.tsx");
export const fetchShareDialog = () => import("./ShareDialog.tsx");
