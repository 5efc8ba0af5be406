// Sums, signs and symmetry of a blur's weights, and the message about faulty ones.
#include "Blur/KernelAudit.h"

#include "Blur/KernelAuditErrors.h"
#include "RenderGraphNotes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace Drydock
{

namespace
{

constexpr double SumTolerance = 1e-3; // tables are printed with four digits
constexpr double WeightTolerance = 1e-6;

} // namespace

bool FKernelAudit::IsSound() const
{
	return bFinite && !bNegative && bSymmetric && bOneLobe && std::abs(Sum - 1.0) <= SumTolerance;
}

std::string FKernelAudit::DescribeFaults() const
{
	std::string Faults;
	const auto Add = [&Faults](const std::string& Fault)
	{
		Faults += (Faults.empty() ? "" : "; ") + Fault;
	};
	if (!bFinite)
	{
		return "its weights are not finite";
	}
	if (std::abs(Sum - 1.0) > SumTolerance)
	{
		char Number[32];
		std::snprintf(Number, sizeof(Number), "%.4f", Sum);
		Add(std::string("its weights sum to ") + Number + ", which each pass multiplies the light by");
	}
	if (bNegative)
	{
		Add("it has negative weights");
	}
	if (!bSymmetric)
	{
		Add("it is not symmetric, so it moves the picture");
	}
	if (!bOneLobe)
	{
		Add("its weights rise away from the centre: what it blurs gets several lobes");
	}
	return Faults;
}

FKernelAudit AuditKernel(const std::vector<double>& Weights)
{
	FKernelAudit Audit;
	double Largest = 0.0;
	for (const double Weight : Weights)
	{
		Audit.Sum += Weight;
		Audit.bFinite = Audit.bFinite && std::isfinite(Weight);
		Audit.bNegative = Audit.bNegative || Weight < 0.0;
		Largest = std::max(Largest, std::abs(Weight));
	}
	const double Tolerance = Largest * WeightTolerance;
	for (size_t Left = 0, Right = Weights.size(); Left < Right--; ++Left)
	{
		const double Difference = std::abs(Weights[Left] - Weights[Right]);
		Audit.bSymmetric = Audit.bSymmetric && Difference <= Tolerance;
		const bool bHasInner = Left + 1 < Right;
		const double Rise =
			bHasInner ? std::max(Weights[Left] - Weights[Left + 1], Weights[Right] - Weights[Right - 1]) : 0.0;
		Audit.bOneLobe = Audit.bOneLobe && Rise <= Tolerance;
	}
	return Audit;
}

void CheckKernel(
	FRDGBuilder& GraphBuilder, const std::string& Name, const std::vector<double>& Weights, EKernelFault Declared)
{
	const FKernelAudit Audit = AuditKernel(Weights);
	if (Audit.IsSound())
	{
		return;
	}
	const bool bDeclared = Declared == EKernelFault::Printed;
	FDiagnostic Diagnostic;
	Diagnostic.Severity = bDeclared ? ESeverity::Warning : ESeverity::Error;
	Diagnostic.Code = bDeclared ? WarnKernelDeclared : ErrorKernelFaulty;
	Diagnostic.Where = Name;
	Diagnostic.Message = "the kernel is faulty" + std::string(bDeclared ? " as its article prints it" : "") + ": " +
						 Audit.DescribeFaults();
	if (!bDeclared)
	{
		throw FError(Diagnostic, ExitUsage);
	}
	AddGraphNote(GraphBuilder, Diagnostic);
}

} // namespace Drydock
