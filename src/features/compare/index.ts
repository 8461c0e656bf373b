/* Comparison of two programs. */

export const fetchCompareDialog = () => import("./CompareDialog.tsx");
