// Who writes the output of a sequence of passes.
#include <gtest/gtest.h>

#include "Chain/OverridePassSequence.h"
#include "RenderGraphBuilder.h"

namespace
{

enum class EPass : uint32
{
	A,
	B,
	C,
	MAX
};

class OverridePassSequence : public testing::Test
{
protected:
	OverridePassSequence()
		: GraphBuilder(FRHICommandListExecutor::GetImmediateCommandList())
		, Sequence(FScreenPassRenderTarget(
			  GraphBuilder.CreateTexture(FRDGTextureDesc::Create2D(FIntPoint(4, 4), PF_B8G8R8A8,
											 FClearValueBinding::Black, TexCreate_RenderTargetable),
				  TEXT("Output")),
			  ERenderTargetLoadAction::ENoAction))
	{
	}
	~OverridePassSequence() override { GraphBuilder.Discard(); }

	void Enable(bool bA, bool bB, bool bC)
	{
		Sequence.SetEnabled(EPass::A, bA);
		Sequence.SetEnabled(EPass::B, bB);
		Sequence.SetEnabled(EPass::C, bC);
		Sequence.Finalize();
	}
	bool Accepts(EPass Pass, std::optional<int32> Callback = {})
	{
		FScreenPassRenderTarget Target;
		return Sequence.AcceptOverrideIfLastPass(Pass, Target, Callback) && Target.IsValid();
	}

	FRDGBuilder GraphBuilder;
	TOverridePassSequence<EPass> Sequence;
};

} // namespace

TEST_F(OverridePassSequence, LastEnabledPassTakesIt)
{
	Enable(true, true, false);
	EXPECT_FALSE(Accepts(EPass::A));
	EXPECT_TRUE(Accepts(EPass::B));
	EXPECT_FALSE(Accepts(EPass::C));
	EXPECT_TRUE(Sequence.IsAfterLastPass(EPass::C));
}

TEST_F(OverridePassSequence, ItsLastCallbackTakesItInstead)
{
	Enable(true, true, false);
	Sequence.SetNumCallbacks(EPass::B, 2);
	EXPECT_FALSE(Accepts(EPass::B));
	EXPECT_FALSE(Accepts(EPass::B, 0));
	EXPECT_TRUE(Accepts(EPass::B, 1));
}

TEST_F(OverridePassSequence, CallbacksOfOtherPassesNeverDo)
{
	Enable(true, true, false);
	Sequence.SetNumCallbacks(EPass::A, 1);
	Sequence.SetNumCallbacks(EPass::C, 1);
	EXPECT_FALSE(Accepts(EPass::A, 0));
	EXPECT_FALSE(Accepts(EPass::C, 0));
}

TEST_F(OverridePassSequence, NobodyTakesItWhereNothingIsEnabled)
{
	Enable(false, false, false);
	EXPECT_FALSE(Accepts(EPass::C));
	EXPECT_FALSE(Sequence.GetLastPass().has_value());
}
