/* Two programs beside each other. */

export const fetchCompareDialog = () => import("./CompareDialog.tsx");
