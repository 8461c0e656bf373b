/* Works that come from elsewhere, or go there. */

export const fetchHandOnDialog = () => import("./HandOnDialog.tsx");
