// Picks the cost and the error that a chart shows, and maps errors to its axis.
#include "Study/StudyView.h"

#include "Budget/StudyBudget.h"
#include "Study/StudyRank.h"
#include "Text/Fmt.inl"

#include <algorithm>
#include <cmath>

namespace Drydock
{

namespace
{

/** Of the errors, those from Floor on. */
std::vector<double> KeepFrom(std::vector<double> Errors, double Floor)
{
	Errors.erase(
		std::remove_if(Errors.begin(), Errors.end(), [&](double Error) { return Error < Floor; }), Errors.end());
	return Errors;
}

std::vector<double> Append(std::vector<double> A, const std::vector<double>& B)
{
	A.insert(A.end(), B.begin(), B.end());
	return A;
}

/** "2e-7": one digit. */
std::string RoughText(double Number)
{
	std::string Text = fmt::format("{:.0e}", Number);
	const size_t Zero = Text.find("e-0");
	return Zero == std::string::npos ? Text : Text.erase(Zero + 2, 1);
}

} // namespace

double FStudyView::GetCost(const FStudyVariant& Variant) const
{
	return Cost == EStudyCost::Taps ? Variant.Taps : Variant.Time.Median;
}

double FStudyView::GetError(const FStudyVariant& Variant) const
{
	return GetErrorToRank(Variant.Error, Result.GetMetric());
}

bool FStudyView::IsRecommended(const FStudyVariant& Variant) const
{
	return Cost == EStudyCost::Milliseconds && Variant.bRecommended;
}

const FStudyRank& FStudyView::GetRank(const FStudyVariant& Variant) const
{
	return Cost == EStudyCost::Taps ? Variant.ByTaps : Variant.ByTime;
}

std::string FStudyView::GetCostName() const
{
	return Cost == EStudyCost::Taps ? "taps per pixel" : "CPU ms";
}

size_t FStudyView::GetNumChoices() const
{
	return Result.Jobs.empty() ? 0 : Result.Jobs[0].Variants.size();
}

std::optional<double> FStudyView::GetBudgetError() const
{
	const FStudyBudget& Budget = Result.Study.Budget;
	if (!Budget.Max || Budget.Metric != Result.GetMetric())
	{
		return std::nullopt;
	}
	return Budget.Metric == "psnr"   ? std::pow(10.0, -*Budget.Max / 20.0)
		   : Budget.Metric == "ssim" ? 1.0 - *Budget.Max
									 : *Budget.Max;
}

std::string FStudyView::DrawBudget(const FSvgBox& Plot, const FLogAxis& Y) const
{
	const std::optional<double> Budget = GetBudgetError();
	if (!Budget || *Budget <= Y.GetLow() || *Budget >= Y.GetHigh())
	{
		return "";
	}
	const double Place = Y.Map(*Budget);
	return SvgRect({Plot.Left, Place, Plot.Right, Plot.Bottom}, "within") +
		   SvgLine(Plot.Left, Place, Plot.Right, Place, "budget");
}

FErrorAxis::FErrorAxis(const std::vector<double>& Errors, const std::vector<double>& Shown, const FSvgBox& Plot)
	: Floor(FindFloor(Errors))
	, Axis(Append(KeepFrom(Errors, Floor), Shown), Plot.Bottom - (Floor > 0.0 ? 28.0 : 0.0), Plot.Top)
	, Edge(Plot.Bottom - 12.0)
{
}

double FErrorAxis::Map(double Error) const
{
	return IsBelow(Error) ? Edge : Axis.Map(Error);
}

std::string FErrorAxis::Label(const std::string& Name, double Error) const
{
	return Error == 0.0 ? Name + " (no error)" : IsBelow(Error) ? Name + ": " + RoughText(Error) : Name;
}

double FErrorAxis::FindFloor(std::vector<double> Errors)
{
	constexpr double Gap = 1000.0;
	Errors.erase(
		std::remove_if(Errors.begin(), Errors.end(), [](double Error) { return !(Error > 0.0); }), Errors.end());
	std::sort(Errors.begin(), Errors.end());
	for (size_t NumBelow = 1; 2 * NumBelow < Errors.size(); ++NumBelow)
	{
		if (Errors[NumBelow] > Gap * Errors[NumBelow - 1])
		{
			return Errors[NumBelow];
		}
	}
	return 0.0;
}

} // namespace Drydock
