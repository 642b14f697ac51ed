#include <asperity/law_export/generated_source.h>

#include <algorithm>
#include <cctype>

#include "export_text.h"
#include "exported_numbers.h"

namespace asperity
{
  namespace
  {
    /** Two numbers fit into a line, and 18 lines into a statement: Fortran 77
     *  allows 19 continuation lines. */
    constexpr std::size_t numbers_per_statement = 36;
    constexpr std::size_t columns_for_data      = 66;

    std::string
    statement(const std::string &text)
    {
      return "      " + text + "\n";
    }

    std::string
    data_statements(const std::string &name, const std::vector<double> &values)
    {
      std::string text;
      for (std::size_t begin = 0; begin < values.size();
           begin += numbers_per_statement)
        {
          const std::size_t end =
            std::min(begin + numbers_per_statement, values.size());
          std::vector<std::string> numbers;
          for (std::size_t j = begin; j < end; ++j)
            numbers.push_back(fortran_number(values[j]));
          text +=
            statement("DATA (" + name + "(J),J=" + std::to_string(begin + 1) +
                      "," + std::to_string(end) + ")/");
          for (const std::string &line :
               number_lines(numbers, columns_for_data, "/"))
            text += "     &" + line + "\n";
        }
      return text;
    }

    /** "P", "V" or "T", as the arguments are called. */
    std::string
    argument(const ExportedNumbers::Coordinate &c)
    {
      std::string name = ContactPointLaw::symbols()[c.index];
      name[0] =
        static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
      return name;
    }

    /** What the kernel sees of the inputs, and its derivatives by them. */
    std::string
    scaling(const ExportedNumbers &numbers)
    {
      std::string text =
        "C\nC     WHAT THE KERNEL SEES OF P, V, T, AND ITS DERIVATIVES\n"
        "      SUBROUTINE TRIBSC(P,V,T,SP,SV,ST,DP,DV,DT)\n"
        "      IMPLICIT NONE\n"
        "      DOUBLE PRECISION P,V,T,SP,SV,ST,DP,DV,DT\n"
        "      SP=0D0\n      SV=0D0\n      ST=0D0\n"
        "      DP=0D0\n      DV=0D0\n      DT=0D0\n";
      for (const auto &c : numbers.coordinates)
        {
          const std::string x = argument(c), s = "S" + x, d = "D" + x;
          const std::string span   = fortran_number(c.span),
                            length = fortran_number(c.length);
          if (!c.logarithmic)
            {
              text += statement(d + "=1D0/(" + span + "*" + length + ")") +
                      statement(s + "=(" + x + "-(" + fortran_number(c.origin) +
                                "))") +
                      statement(s + "=" + s + "/" + span + "/" + length);
              continue;
            }
          // tiny numbers have no inverse
          text += statement("IF (" + x + ".GT.1D-300) THEN") +
                  statement("  " + d + "=1D0/(" + x + "*" + span) + "     &*" +
                  length + ")\n" + statement("END IF") +
                  statement(s + "=" + x) +
                  statement("IF (" + x + ".LE.0D0) " + s + "=" +
                            fortran_number(c.lower)) +
                  statement(s + "=(LOG(" + s + ")-(" +
                            fortran_number(c.origin) + "))") +
                  statement(s + "=" + s + "/" + span + "/" + length);
        }
      return text + "      END\n";
    }

    /** In terms of R2, A, RE = (EXP(-A) - 1 + A)/A**2 and E = EXP(-A): F - 1
     *  for small and for large A. */
    struct KernelText
    {
      std::string argument, small, large, slope;
    };

    KernelText
    kernel_text(const KernelKind kernel)
    {
      switch (kernel)
        {
          case KernelKind::rbf:
            return {"0.5D0*R2", "A*(A*RE-1D0)", "E-1D0", "E"};
          case KernelKind::matern_3_2:
            return {"SQRT(3D0*R2)",
                    "A*A*((1D0+A)*RE-1D0)",
                    "(1D0+A)*E-1D0",
                    "3D0*E"};
          case KernelKind::matern_5_2:
            return {"SQRT(5D0*R2)",
                    "A*A*((1D0+A+A*A/3D0)*RE-(2D0+A)/3D0)",
                    "(1D0+A+A*A/3D0)*E-1D0",
                    "5D0/3D0*(1D0+A)*E"};
        }
      return {};
    }

    /** Weight of run J, correlation with it minus 1, -2 times the derivative of
     *  that by r^2, and the differences of the inputs. The only place with the
     *  data. */
    std::string
    correlation(const ExportedNumbers &numbers)
    {
      const KernelText  kernel = kernel_text(numbers.kernel);
      const std::string n      = std::to_string(numbers.weights.size());
      std::string       text =
        "C\nC     WEIGHT OF TRAINING RUN I, CORRELATION WITH IT MINUS 1, WHICH\n"
        "C     IS ACCURATE ALSO FOR SMALL DISTANCES, -2 TIMES ITS DERIVATIVE\n"
        "C     BY R**2, AND THE DIFFERENCES OF THE INPUTS\n"
        "      SUBROUTINE TRIBCR(SP,SV,ST,I,WI,G,SLOPE,DP,DV,DT)\n"
        "      IMPLICIT NONE\n      INTEGER I,J\n"
        "      DOUBLE PRECISION SP,SV,ST,WI,G,SLOPE,DP,DV,DT,R2,A,E,RE\n"
        "      DOUBLE PRECISION TAYLOR(13)\n" +
        statement("DOUBLE PRECISION W(" + n + ")");
      if (!numbers.rest.empty())
        text += statement("DOUBLE PRECISION R(" + n + ")");
      std::string names = "TAYLOR,W";
      for (const auto &c : numbers.coordinates)
        {
          text += statement("DOUBLE PRECISION X" + argument(c) + "(" + n + ")");
          names += ",X" + argument(c);
        }
      text += statement("SAVE " + names + (numbers.rest.empty() ? "" : ",R"));
      text += data_statements("TAYLOR", taylor_coefficients());
      for (const auto &c : numbers.coordinates)
        text += data_statements("X" + argument(c), c.points);
      text += data_statements("W", numbers.weights);
      if (!numbers.rest.empty())
        text += data_statements("R", numbers.rest);
      text += "      WI=W(I)\n      DP=0D0\n      DV=0D0\n      DT=0D0\n" +
              statement(numbers.rest.empty() ? "R2=0D0" : "R2=R(I)");
      for (const auto &c : numbers.coordinates)
        {
          const std::string x = argument(c);
          text += statement("D" + x + "=X" + x + "(I)-S" + x) +
                  statement("R2=R2+D" + x + "*D" + x);
        }
      return text + statement("A=" + kernel.argument) +
             "C     TOO FAR AWAY TO MATTER\n"
             "      G=-1D0\n      SLOPE=0D0\n"
             "      IF (A.GE.700D0) RETURN\n      E=EXP(-A)\n" +
             statement("SLOPE=" + kernel.slope) +
             statement("G=" + kernel.large) +
             "      IF (.NOT.(A.LT.0.5D0)) RETURN\n"
             "C     (EXP(-A)-1+A)/A**2 BY ITS TAYLOR SERIES\n" +
             statement("RE=" + fortran_number(1. / 1307674368000.)) +
             "      DO 10 J=1,13\n        RE=TAYLOR(J)-A*RE\n"
             "   10 CONTINUE\n" +
             statement("G=" + kernel.small) + "      END\n";
    }

    std::string
    inside(const ExportedNumbers &numbers)
    {
      std::string text =
        "C\nC     1 IN THE BOX OF THE TRAINING DATA, ELSE 0\n"
        "      INTEGER FUNCTION TRIBIN(P,V,T)\n      IMPLICIT NONE\n"
        "      DOUBLE PRECISION P,V,T\n      TRIBIN=1\n";
      for (const auto &c : numbers.coordinates)
        text += statement("IF (.NOT.(" + argument(c) + ".GE." +
                          fortran_number(c.lower - c.margin) + ")) TRIBIN=0") +
                statement("IF (.NOT.(" + argument(c) + ".LE." +
                          fortran_number(c.upper + c.margin) + ")) TRIBIN=0");
      return text + "      END\n";
    }

    /** mu from the mean M of the process. */
    std::string
    output(const ExportedNumbers &numbers)
    {
      std::string text =
        statement("XMU=" + fortran_number(numbers.factor) + "*M") +
        statement("XMU=" + fortran_number(numbers.offset) + "+XMU");
      if (numbers.output_scale == Scale::logarithmic)
        text += statement("XMU=EXP(XMU)");
      return text;
    }

    std::string
    mean(const ExportedNumbers &numbers)
    {
      std::string text =
        "C\nC     MU, ITS DERIVATIVES BY P, V, T, AND WHETHER THE POINT IS IN\n"
        "C     THE BOX OF THE TRAINING DATA\n"
        "      SUBROUTINE TRIBMU(P,V,T,XMU,DMU,INSIDE)\n"
        "      IMPLICIT NONE\n      INTEGER INSIDE,I,TRIBIN\n"
        "      DOUBLE PRECISION P,V,T,XMU,DMU(3),SP,SV,ST,SDP,SDV,SDT\n"
        "      DOUBLE PRECISION M,WI,G,SLOPE,DP,DV,DT\n"
        "      CALL TRIBSC(P,V,T,SP,SV,ST,SDP,SDV,SDT)\n"
        "      DMU(1)=0D0\n      DMU(2)=0D0\n      DMU(3)=0D0\n" +
        statement("M=" + fortran_number(numbers.sum_of_weights)) +
        statement("DO 10 I=1," + std::to_string(numbers.weights.size())) +
        "        CALL TRIBCR(SP,SV,ST,I,WI,G,SLOPE,DP,DV,DT)\n"
        "        M=M+WI*G\n"
        "        IF (SLOPE.LE.0D0) GOTO 10\n"
        "        DMU(1)=DMU(1)+WI*SLOPE*DP\n"
        "        DMU(2)=DMU(2)+WI*SLOPE*DV\n"
        "        DMU(3)=DMU(3)+WI*SLOPE*DT\n   10 CONTINUE\n" +
        output(numbers);
      // M becomes the derivative of mu by the process
      text += statement("M=" + fortran_number(numbers.factor));
      if (numbers.output_scale == Scale::logarithmic)
        text += statement("M=M*XMU");
      return text + "      DMU(1)=M*DMU(1)*SDP\n      DMU(2)=M*DMU(2)*SDV\n"
                    "      DMU(3)=M*DMU(3)*SDT\n"
                    "      INSIDE=TRIBIN(P,V,T)\n      END\n";
    }

    std::string
    deviation(const ExportedNumbers &numbers)
    {
      const std::string n = std::to_string(numbers.weights.size());
      std::string       text =
        "C\nC     MU, ITS STANDARD DEVIATION, AND WHETHER IT IS TO BE TRUSTED\n"
        "      SUBROUTINE TRIBSD(P,V,T,XMU,SIGMA,ITRUST,WORK)\n"
        "      IMPLICIT NONE\n      INTEGER ITRUST,TRIBIN,I\n"
        "      DOUBLE PRECISION P,V,T,XMU,SIGMA,WORK(*)\n"
        "      DOUBLE PRECISION SP,SV,ST,SDP,SDV,SDT,M,WI,G,SLOPE\n"
        "      DOUBLE PRECISION DP,DV,DT\n";
      if (!numbers.B.empty())
        text += "      INTEGER J,K\n      DOUBLE PRECISION TOTAL,ROW\n" +
                statement("DOUBLE PRECISION B(" +
                          std::to_string(numbers.B.size()) + ")") +
                statement("SAVE B") + data_statements("B", numbers.B);
      text += "      CALL TRIBSC(P,V,T,SP,SV,ST,SDP,SDV,SDT)\n" +
              statement("M=" + fortran_number(numbers.sum_of_weights)) +
              statement("DO 10 I=1," + n) +
              "        CALL TRIBCR(SP,SV,ST,I,WI,G,SLOPE,DP,DV,DT)\n"
              "        M=M+WI*G\n        WORK(I)=1D0+G\n   10 CONTINUE\n" +
              output(numbers);
      if (numbers.B.empty())
        return text + "      SIGMA=-1D0\n      ITRUST=TRIBIN(P,V,T)\n"
                      "      END\n";
      text += "      K=0\n      TOTAL=0D0\n" + statement("DO 30 I=1," + n) +
              "        ROW=0D0\n        DO 20 J=1,I\n"
              "          ROW=ROW+B(K+J)*WORK(J)\n   20   CONTINUE\n"
              "        K=K+I\n        TOTAL=TOTAL+ROW*ROW\n   30 CONTINUE\n"
              "      SIGMA=0D0\n      IF (.NOT.(TOTAL.GE.1D0)) THEN\n" +
              statement("  SIGMA=" + fortran_number(numbers.signal_variance)) +
              "        SIGMA=SQRT(SIGMA*(1D0-TOTAL))\n      END IF\n" +
              statement("SIGMA=SIGMA*" + fortran_number(numbers.factor));
      if (numbers.output_scale == Scale::logarithmic)
        text += statement("SIGMA=SIGMA*XMU");
      return text + "      ITRUST=0\n" +
             statement("IF (SIGMA.LE." +
                       fortran_number(numbers.largest_trusted_deviation) +
                       "*ABS(XMU))") +
             "     &ITRUST=TRIBIN(P,V,T)\n      END\n";
    }

    std::string
    shear(const ShearLimit &limit)
    {
      std::string text =
        "C\nC     SHEAR LIMIT K AND ITS DERIVATIVE BY T; 1D300 IF UNKNOWN\n"
        "      SUBROUTINE TRIBK(T,XK,DXK)\n      IMPLICIT NONE\n"
        "      DOUBLE PRECISION T,XK,DXK,R,S\n";
      if (!(limit.k_0 > 0.))
        text += "      XK=1D300\n      DXK=0D0\n      R=T\n      S=R\n";
      else
        text +=
          statement("XK=" + fortran_number(limit.k_0)) + "      DXK=0D0\n" +
          statement("R=" + fortran_number(limit.melting_temperature -
                                          limit.transition_temperature)) +
          statement("S=(T-" + fortran_number(limit.transition_temperature) +
                    ")/R") +
          "      IF (S.LE.0D0) RETURN\n"
          "      IF (.NOT.(S.GE.1D0)) THEN\n" +
          statement("  DXK=-XK*" + fortran_number(limit.exponent) + "/R") +
          statement("  DXK=DXK*S**(" + fortran_number(limit.exponent - 1.) +
                    ")") +
          statement("  XK=XK*(1D0-S**" + fortran_number(limit.exponent) + ")") +
          "      ELSE\n        XK=0D0\n      END IF\n";
      return text + "      END\nC\nC     SHEAR STRESS MIN(MU*P,K)\n"
                    "      DOUBLE PRECISION FUNCTION TRIBTA(P,V,T)\n"
                    "      IMPLICIT NONE\n      INTEGER INSIDE\n"
                    "      DOUBLE PRECISION P,V,T,XMU,DMU(3),XK,DXK\n"
                    "      CALL TRIBMU(P,V,T,XMU,DMU,INSIDE)\n"
                    "      CALL TRIBK(T,XK,DXK)\n      TRIBTA=MIN(XMU*P,XK)\n"
                    "      END\n";
    }

    std::vector<std::string>
    title(const ExportedNumbers &numbers)
    {
      const std::string        n     = std::to_string(numbers.weights.size());
      std::vector<std::string> lines = {
        "Friction coefficient by pressure P [Pa], sliding velocity V [m/s]",
        "and temperature T [K]. Fortran 77; everything DOUBLE PRECISION.",
        "",
        "SUBROUTINE TRIBMU(P,V,T,XMU,DMU,INSIDE)",
        "  XMU: mu; DMU(3): its derivatives by P, V and T",
        "  INSIDE: 1 in the box of the training data, else 0",
        "SUBROUTINE TRIBSD(P,V,T,XMU,SIGMA,ITRUST,WORK)",
        "  SIGMA: standard deviation of mu; ITRUST: 1 if mu is to be",
        "  trusted, else 0; WORK: room for " + n + " numbers"};
      for (const std::string &line :
           numbers.B.empty() ?
             std::vector<std::string>{
               "  Written without the deviation: SIGMA is -1, and ITRUST is 1",
               "  in the box."} :
             std::vector<std::string>{
               "  ITRUST: in the box, and the deviation is small."})
        lines.push_back(line);
      for (const char *const line :
           {"SUBROUTINE TRIBK(T,XK,DXK)",
            "  XK: shear limit k [Pa]; DXK: its derivative by T",
            "DOUBLE PRECISION FUNCTION TRIBTA(P,V,T): min(mu p, k) [Pa]",
            "",
            "Outside of the box the law is still answered, with finite",
            "numbers: far away it falls back to the mean of its data. A",
            "pressure, velocity or temperature that is not positive is",
            "replaced by the lower end of its range if the law sees its",
            "logarithm (see the ranges below); the derivative by it is 0",
            "then."})
        lines.push_back(line);
      return lines;
    }
  } // namespace



  std::string
  fortran_source(const ContactPointLaw &law, const bool with_deviation)
  {
    const ExportedNumbers numbers(law, with_deviation);
    return comment_header(title(numbers), law, "C") + mean(numbers) +
           deviation(numbers) + shear(numbers.shear_limit) + inside(numbers) +
           scaling(numbers) + correlation(numbers);
  }
} // namespace asperity
