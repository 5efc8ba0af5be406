// Declares GEngine and the objects that code from outside reaches through it. Source: engine file Engine/Engine.h.
#pragma once

#include "CoreMinimal.h"
#include "Engine/World.h"
#include "Subsystems/EngineSubsystem.h"
#include "UObject/Object.h"

class FRDGBuilder;
class FSceneViewExtensions;

DECLARE_MULTICAST_DELEGATE_OneParam(FPreRenderDelegateEx, FRDGBuilder&);
DECLARE_MULTICAST_DELEGATE_OneParam(FPostRenderDelegateEx, FRDGBuilder&);

/** The action of GetWorldFromContextObject when an object has no world. */
enum class EGetWorldErrorMode
{
	ReturnNull,
	LogAndReturnNull,
	Assert
};

class DRYDOCK_API UEngine : public UObject
{
public:
	UEngine();
	~UEngine() override;

	/** Always valid. */
	TSharedPtr<FSceneViewExtensions> ViewExtensions;

	/** Null if no plugin brings it. */
	template<typename T>
	T* GetEngineSubsystem() const
	{
		return Drydock::FSubsystems::Get().Find<T>(Drydock::ESubsystemKind::Engine);
	}
	/** The world of an object; null where it is null or has none. */
	UWorld* GetWorldFromContextObject(const UObject* Object, EGetWorldErrorMode ErrorMode) const;
	UWorld* GetWorldFromContextObjectChecked(const UObject* Object) const
	{
		return GetWorldFromContextObject(Object, EGetWorldErrorMode::Assert);
	}
	/** One: the game's. */
	const TArray<FWorldContext>& GetWorldContexts() const;
	/** A line of the log, as there is no screen; each text once. */
	void AddOnScreenDebugMessage(uint64 Key, float TimeToDisplay, FColor DisplayColor, const FString& DebugMessage,
		bool bNewerOnTop = true, const FVector2D& TextScale = FVector2D(1.0, 1.0));
	/** Null: there is no window. */
	UGameViewportClient* GameViewport = nullptr;

	/** Called in each frame's graph: before its passes, and behind its post-processing. */
	FPreRenderDelegateEx& GetPreRenderDelegateEx() { return PreRenderDelegateEx; }
	FPostRenderDelegateEx& GetPostRenderDelegateEx() { return PostRenderDelegateEx; }

	UWorld* GetCurrentPlayWorld(UWorld* = nullptr) const { return GWorld; }

private:
	FPreRenderDelegateEx PreRenderDelegateEx;
	FPostRenderDelegateEx PostRenderDelegateEx;
};

/** Valid from the moment the library is loaded. */
extern DRYDOCK_API UEngine* GEngine;
