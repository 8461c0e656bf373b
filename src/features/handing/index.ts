/* Sharing of works, both ways. */

export const fetchHandOnDialog = () => import("./HandOnDialog.tsx");
