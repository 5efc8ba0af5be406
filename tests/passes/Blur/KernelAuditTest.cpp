// The kernel audit: what it calls sound, what it warns of and what it refuses.
#include "PassTestUtils.h"

#include "Bloom/UnityBloom.h"
#include "Blur/KernelAudit.h"
#include "Blur/KernelAuditErrors.h"
#include "Lens/REDPostProcess.h"
#include "RenderGraphNotes.h"

using namespace Drydock;
using PassTest::FPassRun;

namespace
{

std::vector<FDiagnostic> Check(const std::vector<double>& Weights, EKernelFault Declared)
{
	FPassRun Run(PassTest::FImage(2, 2), PassTest::EArithmetic::Native);
	CheckKernel(Run.GraphBuilder, "Test blur", Weights, Declared);
	const std::vector<FDiagnostic> Notes = GetGraphNotes(Run.GraphBuilder);
	Run.Execute(Run.Input);
	return Notes;
}

std::vector<FDiagnostic> BlurRed(bool bAsPrinted)
{
	FPassRun Run(PassTest::FImage(4, 4), PassTest::EArithmetic::Native);
	FREDPostProcessPassInputs Inputs;
	Inputs.Parameters.bAsPrinted = bAsPrinted;
	Inputs.SceneColor = Run.Input;
	for (const EREDPostProcessPass Pass : {EREDPostProcessPass::BlurH, EREDPostProcessPass::BlurV})
	{
		Inputs.Pass = Pass;
		Inputs.SceneColor = AddREDPostProcessPass(Run.GraphBuilder, Run.View, Inputs);
	}
	const std::vector<FDiagnostic> Notes = GetGraphNotes(Run.GraphBuilder);
	Run.Execute(Inputs.SceneColor);
	return Notes;
}

} // namespace

TEST(KernelAudit, SoundKernelsPass)
{
	EXPECT_TRUE(AuditKernel({1}).IsSound());
	EXPECT_TRUE(AuditKernel({0.5, 0.5}).IsSound());
	EXPECT_TRUE(AuditKernel({0.25, 0.5, 0.25}).IsSound());
	EXPECT_TRUE(AuditKernel({0.2, 0.2, 0.2, 0.2, 0.2}).IsSound());
	EXPECT_EQ("", AuditKernel({0.25, 0.5, 0.25}).DescribeFaults());
}

TEST(KernelAudit, SumIsTheGain)
{
	const FKernelAudit Audit = AuditKernel({0.5, 1, 0.5});
	EXPECT_EQ(2, Audit.Sum);
	EXPECT_FALSE(Audit.IsSound());
	EXPECT_EQ("its weights sum to 2.0000, which each pass multiplies the light by", Audit.DescribeFaults());
}

TEST(KernelAudit, SumMayMissOneByTheDigitsOfATable)
{
	EXPECT_TRUE(AuditKernel({0.2496, 0.5, 0.2496}).IsSound()); // 0.9992
	EXPECT_FALSE(AuditKernel({0.249, 0.5, 0.249}).IsSound());  // 0.998
}

TEST(KernelAudit, LobesAreSeen)
{
	const FKernelAudit Audit = AuditKernel({0.2, 0.25, 0.1, 0.25, 0.2});
	EXPECT_FALSE(Audit.bOneLobe);
	EXPECT_TRUE(Audit.bSymmetric);
	EXPECT_FALSE(Audit.IsSound());
}

TEST(KernelAudit, LopsidedKernelsAreSeen)
{
	EXPECT_FALSE(AuditKernel({0.2, 0.5, 0.3}).bSymmetric);
	EXPECT_TRUE(AuditKernel({0.2, 0.5, 0.3}).bOneLobe);
}

TEST(KernelAudit, NegativeAndNotFiniteWeightsAreFaults)
{
	EXPECT_TRUE(AuditKernel({-0.25, 1.5, -0.25}).bNegative);
	EXPECT_FALSE(AuditKernel({-0.25, 1.5, -0.25}).IsSound());
	EXPECT_EQ("its weights are not finite", AuditKernel({0.25, PassTest::NaN, 0.25}).DescribeFaults());
	EXPECT_FALSE(AuditKernel({PassTest::Infinity}).IsSound());
}

TEST(KernelAudit, KernelOfNothingIsNone)
{
	EXPECT_FALSE(AuditKernel({}).IsSound());
}

TEST(KernelAudit, UndeclaredFaultIsRefused)
{
	try
	{
		Check({0.5, 1, 0.5}, EKernelFault::None);
		FAIL();
	}
	catch (const FError& Error)
	{
		EXPECT_EQ(ExitUsage, Error.GetExitCode());
		EXPECT_EQ(ErrorKernelFaulty, Error.GetDiagnostics().at(0).Code);
		EXPECT_EQ("Test blur", Error.GetDiagnostics().at(0).Where);
	}
}

TEST(KernelAudit, DeclaredFaultIsAWarning)
{
	const std::vector<FDiagnostic> Notes = Check({0.5, 1, 0.5}, EKernelFault::Printed);
	ASSERT_EQ(1u, Notes.size());
	EXPECT_EQ(WarnKernelDeclared, Notes[0].Code);
	EXPECT_EQ(ESeverity::Warning, Notes[0].Severity);
}

TEST(KernelAudit, SoundKernelSaysNothing)
{
	EXPECT_TRUE(Check({0.25, 0.5, 0.25}, EKernelFault::None).empty());
	EXPECT_TRUE(Check({0.25, 0.5, 0.25}, EKernelFault::Printed).empty());
}

TEST(KernelAudit, PrintedBlurOfRedWarnsOnceOfItsGainAndLobes)
{
	const std::vector<FDiagnostic> Notes = BlurRed(true);
	ASSERT_EQ(1u, Notes.size());
	EXPECT_EQ(WarnKernelDeclared, Notes[0].Code);
	EXPECT_NE(std::string::npos, Notes[0].Message.find("1.9952"));
	EXPECT_NE(std::string::npos, Notes[0].Message.find("lobes"));
}

TEST(KernelAudit, CorrectedBlurOfRedIsSound)
{
	EXPECT_TRUE(BlurRed(false).empty());
}

TEST(KernelAudit, BlurOfUnityBloomIsSoundInBothForms)
{
	for (const bool bAsPrinted : {false, true})
	{
		FPassRun Run(PassTest::FImage(4, 4), PassTest::EArithmetic::Native);
		FUnityBloomPassInputs Inputs;
		Inputs.Pass = EUnityBloomPass::GaussianBlurVertical;
		Inputs.Source = Run.Input;
		Inputs.bAsPrinted = bAsPrinted;
		Run.Execute(AddUnityBloomPass(Run.GraphBuilder, Run.View, Inputs));
		EXPECT_TRUE(GetGraphNotes(Run.GraphBuilder).empty());
	}
}
