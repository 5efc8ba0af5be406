// Textures and buffers that a view hands from one frame to the next.
#include "SceneViewState.h"

#include "RenderGraphBuilder.h"
#include "ScreenPass.h"

#include <cstring>

void FSceneViewState::BeginFrame(Drydock::FViewHistory InLast)
{
	Last = MoveTemp(InLast);
	Next = Drydock::FViewHistory();
	Caches.BeginFrame();
}

Drydock::FViewHistory FSceneViewState::EndFrame()
{
	Next.bHasCaches = Caches.EndFrame();
	Last = Drydock::FViewHistory();
	return MoveTemp(Next);
}

FScreenPassTexture FSceneViewState::RegisterLastTexture(FRDGBuilder& GraphBuilder, const TCHAR* Name) const
{
	const auto Found = Last.Textures.find(Name);
	return Found == Last.Textures.end()
			   ? FScreenPassTexture()
			   : FScreenPassTexture(GraphBuilder.RegisterExternalTexture(Found->second.Target, Found->first.c_str()),
					 Found->second.ViewRect);
}

FRDGBufferRef FSceneViewState::RegisterLastBuffer(FRDGBuilder& GraphBuilder, const TCHAR* Name) const
{
	const auto Found = Last.Buffers.find(Name);
	return Found == Last.Buffers.end() ? nullptr
									   : GraphBuilder.RegisterExternalBuffer(Found->second, Found->first.c_str());
}

void FSceneViewState::KeepTexture(FRDGBuilder& GraphBuilder, const TCHAR* Name, const FScreenPassTexture& Texture)
{
	Drydock::FHistoryTexture& Kept = Next.Textures[Name];
	Kept.ViewRect = Texture.ViewRect;
	GraphBuilder.QueueTextureExtraction(Texture.Texture, &Kept.Target);
}

void FSceneViewState::KeepBuffer(FRDGBuilder& GraphBuilder, const TCHAR* Name, FRDGBufferRef Buffer)
{
	GraphBuilder.QueueBufferExtraction(Buffer, &Next.Buffers[Name]);
}

float FSceneViewState::GetLastEyeAdaptationExposure() const
{
	const auto Found = Last.Buffers.find(Drydock::EyeAdaptationName);
	if (Found == Last.Buffers.end())
	{
		return 0.0f;
	}
	float Scale = 0.0f; // the buffer's first number
	std::memcpy(&Scale, Found->second->GetRHI()->GetData(), sizeof(Scale));
	return Scale;
}
