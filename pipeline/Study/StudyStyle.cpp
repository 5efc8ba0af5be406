// Holds the style sheet and the markers of a study's drawings. The first colours are those that colour-blind readers
// tell apart too.
#include "Study/StudyStyle.h"

#include "Picture/SvgTools.h"

namespace Drydock
{

namespace
{

constexpr size_t NumColors = 10;

const char* const LightStyle =
	".title{font-size:19px;font-weight:600}.name{font-size:13.5px;font-weight:600}.quiet{fill:#59636e}.tick{font-size:"
	"11px}"
	".label{font-size:11px}.strong{font-weight:600}\n"
	".end{text-anchor:end}.mid{text-anchor:middle}.page{fill:#ffffff}.plot{fill:#818b98;fill-opacity:.06}\n"
	".grid{stroke:#d1d9e0;stroke-width:.7}.leader{stroke:#818b98;stroke-width:.8}.whisker{stroke-width:1.4;stroke-"
	"opacity:.6}\n"
	".front{fill:none;stroke:#1f2328;stroke-width:1.6;stroke-opacity:.55;stroke-linejoin:round}\n"
	".budget{stroke:#cf222e;stroke-width:1.2;stroke-dasharray:6 4}.budgettext{font-size:11px;fill:#cf222e}"
	".within{fill:#1a7f37;fill-opacity:.07}\n"
	".pick{fill:none;stroke:#1a7f37;stroke-width:2.2}.now{fill:none;stroke:#1f2328;stroke-width:1.5;stroke-dasharray:3 "
	"2.4}\n"
	".line{fill:none;stroke-width:2;stroke-linejoin:round;stroke-linecap:round}.dot{stroke:#ffffff;stroke-width:1.2}"
	".off{fill-opacity:.35}\n"
	".f0{fill:#d9730d}.s0{stroke:#d9730d}.f1{fill:#2f6fdb}.s1{stroke:#2f6fdb}.f2{fill:#2a9d68}.s2{stroke:#2a9d68}"
	".f3{fill:#a651b5}.s3{stroke:#a651b5}.f4{fill:#b08d00}.s4{stroke:#b08d00}.f5{fill:#1b97b0}.s5{stroke:#1b97b0}"
	".f6{fill:#c2335c}.s6{stroke:#c2335c}.f7{fill:#6e7781}.s7{stroke:#6e7781}.f8{fill:#5b4fc9}.s8{stroke:#5b4fc9}"
	".f9{fill:#7a8f1e}.s9{stroke:#7a8f1e}\n";

const char* const DarkStyle =
	".front{stroke:#e6edf3}.now{stroke:#e6edf3}.pick{stroke:#3fb950}.budget{stroke:#ff7b72}"
	".budgettext{fill:#ff7b72}.within{fill:#3fb950}"
	".f0{fill:#f0883e}.s0{stroke:#f0883e}.f1{fill:#58a6ff}.s1{stroke:#58a6ff}.f2{fill:#3fb950}.s2{stroke:#3fb950}"
	".f3{fill:#d2a8ff}.s3{stroke:#d2a8ff}.f4{fill:#e3b341}.s4{stroke:#e3b341}.f5{fill:#56d4dd}.s5{stroke:#56d4dd}"
	".f6{fill:#ff7b9c}.s6{stroke:#ff7b9c}.f7{fill:#9198a1}.s7{stroke:#9198a1}.f8{fill:#a5a0ff}.s8{stroke:#a5a0ff}"
	".f9{fill:#b9ce5a}.s9{stroke:#b9ce5a}";

} // namespace

std::string BeginStudySvg(double Height, const std::string& Title)
{
	return BeginSvg(StudyPageWidth, Height, Title, LightStyle, DarkStyle) + SvgPage(StudyPageWidth, Height, 8.0);
}

std::string GetStudyColor(size_t Choice)
{
	return std::to_string(Choice % NumColors);
}

std::string DrawStudyMarker(double X, double Y, double Radius, bool bDiamond, const std::string& Class)
{
	if (!bDiamond)
	{
		return "<circle cx=\"" + Px(X) + "\" cy=\"" + Px(Y) + "\" r=\"" + Px(Radius) + "\" class=\"" + Class + "\"/>\n";
	}
	const double R = Radius * 1.25;
	return "<path d=\"M" + Px(X - R) + " " + Px(Y) + " L" + Px(X) + " " + Px(Y - R) + " L" + Px(X + R) + " " + Px(Y) +
		   " L" + Px(X) + " " + Px(Y + R) + " Z\" class=\"" + Class + "\"/>\n";
}

} // namespace Drydock
