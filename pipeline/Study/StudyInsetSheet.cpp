// Draws the pictures of a study and the maps of their errors into one SVG.
#include "Study/StudyInsetSheet.h"

#include "Math/ToInteger.h"
#include "Picture/ImageMetrics.h"
#include "Picture/SvgTools.h"
#include "Text/Fmt.inl"
#include "Text/TextFormat.h"

#include <algorithm>

namespace Drydock
{

std::string DrawStudyInsets(const std::string& Title, const std::vector<FStudyInsetRow>& Rows)
{
	constexpr double Gap = 10.0;
	size_t Columns = 1;
	for (const FStudyInsetRow& Row : Rows)
	{
		Columns = std::max(Columns, Row.Insets.size());
	}
	const double InsetWidth =
		std::min(260.0, (SvgPageWidth - 2.0 * SvgPageMargin + Gap) / static_cast<double>(Columns) - Gap);
	std::string Body = SvgText(SvgPageMargin, 36.0, "title", Title);
	double Y = 52.0;
	const auto DrawPng = [&](const std::string& Png, double X, double Top, double Height)
	{
		Body += "<image x=\"" + Px(X) + "\" y=\"" + Px(Top) + "\" width=\"" + Px(InsetWidth) + "\" height=\"" +
				Px(Height) + "\" href=\"data:image/png;base64," + EncodeBase64(Png) + "\"/>\n";
	};
	for (const FStudyInsetRow& Row : Rows)
	{
		Body += SvgText(SvgPageMargin, Y + 16.0, "name", Row.Title);
		double Bottom = Y + 26.0;
		for (size_t Index = 0; Index < Row.Insets.size(); ++Index)
		{
			const FStudyInset& Inset = Row.Insets[Index];
			const double X = SvgPageMargin + static_cast<double>(Index) * (InsetWidth + Gap);
			const double Height = InsetWidth * Inset.Height / std::max(1, Inset.Width);
			double Top = Y + 26.0;
			DrawPng(Inset.Png, X, Top, Height);
			Top += Height + 16.0;
			Body +=
				SvgText(X, Top, "label strong", Inset.Title) + SvgText(X, Top + 15.0, "label quiet", Inset.Subtitle);
			Top += 24.0;
			if (!Inset.HeatPng.empty())
			{
				DrawPng(Inset.HeatPng, X, Top, Height);
				Body += SvgText(X, Top + Height + 15.0, "label quiet", Inset.HeatTitle);
				Top += Height + 22.0;
			}
			Bottom = std::max(Bottom, Top);
		}
		Y = Bottom + 14.0;
	}
	constexpr int Steps = 40;
	for (int Step = 0; Step < Steps; ++Step)
	{
		double Color[3];
		GetHeatColor((Step + 0.5) / Steps, Color);
		const auto ToByte = [](double Part)
		{
			return ToInteger<unsigned>(Part * 255.0 + 0.5);
		};
		Body += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"6.3\" height=\"10\" fill=\"#{:02x}{:02x}{:02x}\"/>\n",
			Px(SvgPageMargin + Step * 6.0), Px(Y), ToByte(Color[0]), ToByte(Color[1]), ToByte(Color[2]));
	}
	Body += SvgText(SvgPageMargin + Steps * 6.0 + 10.0, Y + 9.0, "label quiet",
		"error, logarithmic: black a ten-thousandth of the largest of its row of pictures, pale yellow the largest");
	return BeginSvg(Y + 28.0, Title) + Body + "</svg>\n";
}

} // namespace Drydock
