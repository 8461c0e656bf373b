/* Sharing of works, both ways. */

export const fetchShareDialog = () => import("./ShareDialog.tsx");
