// Subsystems of a player: there is one, who comes when the world starts. Source: engine
// Subsystems/LocalPlayerSubsystem.h.
#pragma once

#include "Subsystems/Subsystem.h"

class DRYDOCK_API ULocalPlayerSubsystem : public USubsystem
{
public:
	DRYDOCK_CLASS(ULocalPlayerSubsystem, USubsystem)
	using USubsystem::USubsystem;

	static constexpr Drydock::ESubsystemKind SubsystemKind = Drydock::ESubsystemKind::LocalPlayer;
};
