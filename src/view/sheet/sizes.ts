/** Size of the dimension figures of a sheet, mm on paper. */
export const FIGURES = 3;
