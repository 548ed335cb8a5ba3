/* A user-material function in C for tests. What it does, PROPS[0] says. */

#include <math.h>

void xit_(void);
void stdb_abqerr_(const int    *severity,
                  const char   *message,
                  const int    *integers,
                  const double *reals,
                  const char   *words,
                  unsigned long message_length,
                  unsigned long word_length);

enum
{
  elastic,
  echo,
  ask_for_smaller_step,
  return_nan,
  call_xit,
  call_abqerr
};

void
umat(double       *stress,
     double       *statev,
     double       *ddsdde,
     double       *sse,
     double       *spd,
     double       *scd,
     double       *rpl,
     double       *ddsddt,
     double       *drplde,
     double       *drpldt,
     const double *stran,
     const double *dstran,
     const double *time,
     const double *dtime,
     const double *temp,
     const double *dtemp,
     const double *predef,
     const double *dpred,
     const char   *cmname,
     const int    *ndi,
     const int    *nshr,
     const int    *ntens,
     const int    *nstatv,
     const double *props,
     const int    *nprops,
     const double *coords,
     const double *drot,
     double       *pnewdt,
     const double *celent,
     const double *dfgrd0,
     const double *dfgrd1,
     const int    *noel,
     const int    *npt,
     const int    *layer,
     const int    *kspt,
     const int    *kstep,
     const int    *kinc)
{
  const int n = *ntens;
  int       i, j;
  switch ((int)props[0])
    {
      case elastic: /* without symmetry: DDSDDE(i, j) = PROPS(2) (i + 10 j) */
        for (j = 0; j < n; ++j)
          for (i = 0; i < n; ++i)
            {
              ddsdde[i + n * j] = props[1] * (i + 1 + 10 * (j + 1));
              stress[i] += ddsdde[i + n * j] * dstran[j];
            }
        break;
      case echo: /* what it was given, as state variables */
        for (i = 0; i < 6; ++i)
          statev[i] = i < n ? dstran[i] : 0.;
        statev[6]  = drot[0 + 3 * 1]; /* DROT(1, 2) */
        statev[7]  = *dtime;
        statev[8]  = *ndi + 10 * *nshr + 100 * *nstatv + 10000 * *nprops;
        statev[9]  = cmname[0] == 'S' && cmname[79] == ' ';
        statev[10] = dfgrd1[0 + 3 * 1] - dfgrd0[0 + 3 * 1];
        statev[11] = stress[n - 1];
        statev[12] = *celent * *noel * *npt * *layer * *kspt * *kstep * *kinc;
        statev[13] = stran[0] + time[1] + *temp + *dtemp + predef[0] +
                     dpred[0] + coords[2];
        break;
      case ask_for_smaller_step:
        *pnewdt = 0.5;
        break;
      case return_nan:
        stress[0] = NAN;
        break;
      case call_xit:
        xit_();
        break;
      case call_abqerr:
        {
          const int error = -3;
          stdb_abqerr_(&error, "no such sand", 0, 0, "", 12, 0);
          break;
        }
    }
  /* All outputs must be there to be written. */
  *sse = *spd = *scd = *rpl = *drpldt = 0.;
  for (i = 0; i < n; ++i)
    ddsddt[i] = drplde[i] = 0.;
}
